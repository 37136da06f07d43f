#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Builds what the chosen suites need and runs them, two at a time, the next build beside them; tests/run.sh calls it.

The last line is "N passed, N failed, N skipped"; before it stand the slowest suites and, in JSON, build/logs/suites.json.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import time

from counting import counts, figures, troubles
from long_runs import commit_of, remember
from parts import part_of
from schedule import Schedule, longest_first
from suites import BUILDS, LONGEST_FIRST, ROOT, all_suites, folder

LOGS = os.path.join(ROOT, "build", "logs")
LONG_RUNS = os.path.join(LOGS, "long_runs.json")
AT_ONCE = 2  # the machine that the project is tested on has two cores
SLOWEST = 10


def arguments():
    parser = argparse.ArgumentParser(prog="tests/run.sh", description="Sets up, builds and passes the tests.")
    parser.add_argument("--full", nargs="?", const="1/1", metavar="I/N",
                        help="also what is too long for every change; 1/4 ... 4/4: in parts, all of which make the whole")
    parser.add_argument("--only", default="", metavar="PATTERN", help="the suites whose name matches the regular expression")
    parser.add_argument("--list", action="store_true", help="names the suites and ends")
    return parser.parse_args()


def chosen_suites(options):
    suites = [s for s in all_suites() if options.full or not s.full]
    if options.full:
        try:
            part, parts = (int(n) for n in options.full.split("/"))
        except ValueError:
            raise SystemExit("tests/run.sh: --full takes I/N, such as 1/4, not " + options.full)
        suites = part_of(suites, part, parts)
    return [s for s in suites if re.search(options.only, s.name)]


class Runner:
    def __init__(self, is_long):
        self.is_long, self.commit = is_long, commit_of(ROOT)  # of what is built now, whatever is changed meanwhile
        self.started = time.monotonic()
        # Packages of the tests are read a few times: compiling all of them ahead takes longer.
        self.environment = dict(os.environ, PIP_NO_COMPILE="1")
        self.total, self.failed_suites, self.rows = [0, 0, 0], [], []

    def seconds(self):
        return time.monotonic() - self.started

    def start_build(self, build, suites, is_first):
        """Configures, then builds what these suites need, with what suites of earlier builds leave of the machine."""
        print("== building %s (%.0f s)" % (build, self.seconds()), flush=True)
        log = os.path.join(LOGS, "build_%s.log" % build)
        targets = sorted({t for s in suites if s.build == build for t in s.targets})
        whole = "ON" if "JALON_FULL" in os.environ else "OFF"
        command = 'cmake -S "$0" --preset "$1" -DJALON_SANITIZE_WHOLE=' + whole + ' && folder=$2 && shift 2 && { [ $# -eq 0 ] || ninja -C "$folder" "$@"; }'
        with open(log, "w", encoding="utf-8") as out:
            process = subprocess.Popen(["nice", "-n", "0" if is_first else "10", "bash", "-c", command, ROOT, build, folder(build)]
                                       + targets, cwd=ROOT, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        return process, build, time.monotonic(), log

    def finish_build(self, job, code, usage):
        _, build, begin, log = job
        wall, cpu = time.monotonic() - begin, usage.ru_utime + usage.ru_stime
        self.rows.append({"suite": "build " + build, "wall_s": wall, "cpu_s": cpu, "passed": 0})
        print("== built %s in %.0f s, %.0f s of processor" % (build, wall, cpu), flush=True)
        if code:
            lines = open(log, encoding="utf-8", errors="replace").read().splitlines()
            print("\n".join([line for line in lines if re.search("error|FAILED", line)][:40] + lines[-20:]))
        return code == 0

    def start(self, suite):
        log = os.path.join(LOGS, suite.name + ".log")
        os.makedirs(os.path.dirname(log), exist_ok=True)
        work = os.path.join(ROOT, "build", "work", suite.name)  # some write files of odd names
        os.makedirs(work, exist_ok=True)
        is_program = len(suite.command) == 1
        with open(log, "wb") as out:
            process = subprocess.Popen(suite.command, cwd=work if is_program else ROOT, stdout=out, stderr=subprocess.STDOUT,
                                       stdin=subprocess.DEVNULL, env=dict(self.environment, **suite.environment))
        return process, suite, time.monotonic(), log

    def finish(self, job, code, usage):
        _, suite, begin, log = job
        text = open(log, encoding="utf-8", errors="replace").read()
        passed, failed, skipped = counts(text, code)
        for i, n in enumerate((passed, failed, skipped)):
            self.total[i] += n
        wall, cpu = time.monotonic() - begin, usage.ru_utime + usage.ru_stime
        self.rows.append({"suite": suite.name, "passed": passed, "failed": failed, "skipped": skipped, "wall_s": wall, "cpu_s": cpu})
        if self.is_long:
            remember(LONG_RUNS, self.rows[-1], self.commit, time.strftime("%Y-%m-%d"))
        print("%-34s %5d passed %3d failed %3d skipped %5.0f s %5.0f s of processor" % (suite.name, passed, failed, skipped, wall, cpu))
        for line in figures(text):
            print("  " + line)
        if failed:
            self.failed_suites.append(suite.name)
            print("\n".join(troubles(text)))
        sys.stdout.flush()

    def run(self, suites):
        """A build that fails ends the run: nothing after it would mean anything."""
        builds = [build for build in BUILDS if any(s.build == build for s in suites)]
        schedule = Schedule(builds, longest_first(suites, LONGEST_FIRST), AT_ONCE)
        jobs, building = {}, None
        while not schedule.is_over:
            if build := schedule.next_build():
                building = self.start_build(build, suites, build == builds[0])
            while suite := schedule.next_suite():
                job = self.start(suite)
                jobs[job[0].pid] = job
            pid, status, usage = os.wait4(-1, 0)
            code = os.waitstatus_to_exitcode(status)
            if building and pid == building[0].pid:
                if not self.finish_build(building, code, usage):
                    for process, *_ in jobs.values():
                        process.terminate()
                    print("0 passed, 1 failed, 0 skipped")
                    sys.exit(1)
                schedule.build_ended()
                building = None
            elif pid in jobs:
                self.finish(jobs[pid], code, usage)
                schedule.suite_ended(jobs.pop(pid)[1])

    def close(self):
        os.makedirs(LOGS, exist_ok=True)
        with open(os.path.join(LOGS, "suites.json"), "w", encoding="utf-8") as out:
            json.dump(self.rows, out, indent=1)
        print("the slowest:")
        for row in sorted(self.rows, key=lambda r: -r["wall_s"])[:SLOWEST]:
            print("  %-34s %5.0f s" % (row["suite"], row["wall_s"]))
        if self.failed_suites:
            print("failed: " + " ".join(self.failed_suites))
        print("took %.0f s" % self.seconds())
        print("%d passed, %d failed, %d skipped" % tuple(self.total))
        return 1 if self.total[1] or not sum(self.total) else 0


def need_packages(suites):
    names = sorted({n for s in suites for n in s.packages})
    return not names or subprocess.run(["bash", "-c", '. "$0/examples/packages.sh" && need_packages "$@"', ROOT] + names).returncode == 0


def main():
    options = arguments()
    if options.full:
        os.environ["JALON_FULL"] = "1"
    suites = chosen_suites(options)
    if options.list:
        print("\n".join(s.name for s in suites))
        return 0
    if not suites:
        raise SystemExit("tests/run.sh: no suite matches %s" % options.only)
    os.makedirs(LOGS, exist_ok=True)
    if not need_packages(suites):
        return 1
    runner = Runner(is_long=bool(options.full))
    runner.run(suites)
    return runner.close()


if __name__ == "__main__":
    sys.exit(main())
