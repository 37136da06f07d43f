#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the *_test.py beside it against the package jalon that Python finds: run.py [PATTERN]. Behaviours are named as elsewhere.

JALON_CALLED names a file for the list of what the tests called (calls_trace.py, ../called.py).
"""

import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


class Result(unittest.TestResult):
    trace = None

    def startTest(self, test):
        super().startTest(test)
        if self.trace is not None:
            self.trace.test = self.name(test)

    def name(self, test):
        return test.id().split(".")[-1]

    def addSuccess(self, test):
        super().addSuccess(test)
        self.passed = getattr(self, "passed", 0) + 1
        print("ok - " + self.name(test))

    def addFailure(self, test, err):
        super().addFailure(test, err)
        print("not ok - %s\n%s" % (self.name(test), self.failures[-1][1]))

    def addError(self, test, err):
        super().addError(test, err)
        print("not ok - %s\n%s" % (self.name(test), self.errors[-1][1]))

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        print("skipped: %s: %s" % (self.name(test), reason))


def main():
    sys.path.insert(0, HERE)
    loader = unittest.TestLoader()
    loader.testMethodPrefix = "python__"
    if len(sys.argv) > 1:
        loader.testNamePatterns = ["*%s*" % sys.argv[1]]
    result = Result()
    if os.environ.get("JALON_CALLED"):
        import calls_trace
        result.trace = calls_trace.Trace()
        result.trace.watch()
    loader.discover(HERE, "*_test.py").run(result)
    if result.trace is not None:
        result.trace.write(os.environ["JALON_CALLED"])
    failed = len(result.failures) + len(result.errors)
    print("%d passed, %d failed, %d skipped" % (getattr(result, "passed", 0), failed, len(result.skipped)))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
