# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What "jalon compare" writes beside its other work: the same files with one thread and with several; one line and no
output where a file may not become so large, and where the tool is interrupted while it writes.
Usage: written_beside.py JALON REFERENCE.las COMPARED.las"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

INTERRUPTED = 130  # as a shell says it
WRITE_FAILED = 4
ATTEMPTS = 5  # a busy machine may let the tool end before it is interrupted


def compare(jalon, files, out, *options, **popen):
    return subprocess.Popen([jalon, "compare", *files, "-o", out, "--quiet", *options], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, **popen)


def the_same_with_any_threads(jalon, files, work):
    made = []
    for threads in ("1", "2", "5"):
        out = os.path.join(work, "threads" + threads)
        tool = compare(jalon, files, out, "--threads", threads)
        assert tool.wait() == 0, tool.communicate()
        made.append({name: open(os.path.join(out, name), "rb").read() for name in os.listdir(out)
                     if name.endswith((".las", ".ply", ".svg", ".csv", ".dxf", ".geojson"))})
    assert len(made[0]) >= 9 and made[0] == made[1] == made[2], [sorted(m) for m in made]


def no_file_above(most):
    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
    return limited


# The report may be as long as it is, the clouds may not.
def a_file_that_may_not_grow(jalon, files, work):
    whole, out = (os.path.join(work, name) for name in ("whole", "grow"))
    tool = compare(jalon, files, whole)
    assert tool.wait() == 0, tool.communicate()
    size = {name: os.path.getsize(os.path.join(whole, name)) for name in os.listdir(whole)}
    most = size["report.html"] + (64 << 10)
    assert size["compared.las"] > most and size["compared.ply"] > most, size
    tool = compare(jalon, files, out, preexec_fn=no_file_above(most))
    _, errors = tool.communicate()
    assert tool.returncode == WRITE_FAILED and len(errors.splitlines()) == 1, (tool.returncode, errors)
    assert "compared." in errors and not os.path.exists(out), (errors, out)


def begun(folder):
    return any(name.startswith("reference.") for _, _, names in os.walk(folder) for name in names)


def an_interrupt(jalon, files, work):
    for attempt in range(ATTEMPTS):
        out = os.path.join(work, f"interrupted{attempt}")
        tool = compare(jalon, files, out)
        while tool.poll() is None and not begun(out):
            time.sleep(0.0005)
        tool.send_signal(signal.SIGINT)
        _, errors = tool.communicate()
        if tool.returncode != 0:
            assert tool.returncode == INTERRUPTED and len(errors.splitlines()) == 1, (tool.returncode, errors)
            assert not os.path.exists(out), os.listdir(out)
            return
    raise AssertionError("each interrupt came too late")


def main():
    jalon, *files = (os.path.realpath(path) for path in sys.argv[1:])
    for check in (the_same_with_any_threads, a_file_that_may_not_grow, an_interrupt):
        with tempfile.TemporaryDirectory() as work:
            check(jalon, files, work)


main()
