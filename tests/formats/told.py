# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the checks of a file of others tell: a line each, and the closing count."""

MOST_LINES = 5


def tell(subject, checks):
    """checks: a name, and what gives the problems found. The exit code."""
    passed = 0
    for what, check in checks.items():
        found = list(check())
        print("%s - %s %s" % ("not ok" if found else "ok", subject, what))
        for line in found[:MOST_LINES]:
            print("    " + line)
        passed += not found
    print("%d passed, %d failed, 0 skipped" % (passed, len(checks) - passed))
    return int(passed != len(checks))
