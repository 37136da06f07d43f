# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A LAS file that is changed while "jalon compare" works, which reads its fields only when it writes: the tool ends with
the exit code for its input, one line that names the file, and no output. Usage: changed_meanwhile.py JALON REFERENCE.xyz
COMPARED.las OTHER.las; the compared scan is read before the reference, so it is changed as soon as the latter is open."""
import os
import shutil
import subprocess
import sys
import tempfile
import time

READ_FAILED = 3  # "input missing, unreadable or malformed"
ATTEMPTS = 5  # a busy machine may let the tool end before the file is changed


def holds_open(pid, path):
    try:
        folder = f"/proc/{pid}/fd"
        return any(os.path.realpath(f"{folder}/{name}") == path for name in os.listdir(folder))
    except OSError:  # closed meanwhile
        return False


def compared_while(change, jalon, reference, compared):
    """Exit code, standard error and what lies in the folder; None where the change came too late."""
    for _ in range(ATTEMPTS):
        with tempfile.TemporaryDirectory() as work:
            moving, kept = os.path.join(work, "moving.las"), os.path.join(work, "kept.xyz")
            shutil.copy(compared, moving)
            shutil.copy(reference, kept)
            tool = subprocess.Popen([jalon, "compare", kept, moving, "-o", os.path.join(work, "out")],
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            while tool.poll() is None and not holds_open(tool.pid, os.path.realpath(kept)):
                time.sleep(0.0005)
            change(moving)
            out, errors = tool.communicate()
            if tool.returncode != 0:
                return tool.returncode, errors, sorted(os.listdir(work))
    return None


def cut(path):
    os.truncate(path, os.path.getsize(path) // 2)


def replaced_by(other):
    def change(path):
        shutil.copy(other, path + ".new")
        os.replace(path + ".new", path)
    return change


def main():
    jalon, reference, compared, other = (os.path.realpath(path) for path in sys.argv[1:])
    for name, change in (("cut", cut), ("replaced", replaced_by(other)), ("removed", os.remove)):
        got = compared_while(change, jalon, reference, compared)
        assert got is not None, f"{name}: it was compared as if nothing had happened"
        code, errors, files = got
        assert code == READ_FAILED, (name, code, errors)
        assert len(errors.splitlines()) == 1 and "moving.las" in errors, (name, errors)
        assert not [file for file in files if file not in ("kept.xyz", "moving.las")], (name, files)


main()
