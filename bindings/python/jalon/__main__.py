# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""python -m jalon: the command line tool."""

import sys

from ._tool import main

if __name__ == "__main__":
    sys.exit(main())
