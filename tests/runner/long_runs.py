# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the long form of each suite said last, and of which sources: build/logs/long_runs.json, which parts of --full fill one
after the other and reliability/page.py --write takes over."""

import json
import os
import subprocess


def git(root, *words):
    """What it says, or None where there is none of it, or of what it is asked about."""
    try:
        told = subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=False)
    except OSError:
        return None
    return told.stdout if told.returncode == 0 else None


def commit_of(root):
    """The sources by their commit, with + where files were changed since; "" outside of a repository."""
    return (git(root, "describe", "--always", "--abbrev=8", "--exclude=*", "--dirty=+") or "").strip()


def read_long_runs(path):
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as f:
        return json.load(f)


def remember(path, row, commit, date):
    """Adds a suite of a long run, as soon as it ends, to what earlier ones told; one that was skipped takes nothing away."""
    if row["passed"] + row["failed"] == 0:
        return
    runs = read_long_runs(path)
    runs[row["suite"]] = {"commit": commit, "date": date, "passed": row["passed"], "failed": row["failed"], "minutes": round(row["wall_s"] / 60, 1)}
    with open(path, "w", encoding="utf-8") as f:
        json.dump(runs, f, indent=1, sort_keys=True)
        f.write("\n")
