# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The command jalon of an installed package: the command line tool that the wheel carries, with the arguments as they are."""

import os
import subprocess
import sys

TOOL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "jalon.exe" if os.name == "nt" else "jalon")


def main():
    """Runs the tool in the place of this process; where that cannot be, gives back its exit status."""
    if not os.path.exists(TOOL):
        print("jalon: this package was built without the command line tool (-DJALON_BUILD_CLI=ON builds it)", file=sys.stderr)
        return 1
    if os.name == "nt":
        return subprocess.call([TOOL, *sys.argv[1:]])
    return os.execv(TOOL, ["jalon", *sys.argv[1:]])
