#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The programs of a binding's page, each as a file of its class, and the commands: pages.py PAGE OUT_FOLDER SUFFIX

A block of the page (four columns in) with "class NAME" is a program, NAME.SUFFIX; the others are commands and go to commands.txt, a line
each. Prints the names of the programs.
"""

import os
import re
import sys


def blocks(text):
    found, current = [], []
    for line in text.split("\n") + ["end"]:
        if line.startswith("    ") or (current and not line.strip()):
            current.append(line[4:])
        elif current:
            found.append("\n".join(current).rstrip() + "\n")
            current = []
    return found


def main():
    page, folder, suffix = sys.argv[1:4]
    os.makedirs(folder, exist_ok=True)
    commands = []
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for block in blocks(text):
        name = re.search(r"^(?:static )?class (\w+) \{", block, re.M)
        if name is None:
            commands += [line for line in block.split("\n") if line]
            continue
        with open(os.path.join(folder, name.group(1) + suffix), "w", encoding="utf-8") as file:
            file.write(block)
        print(name.group(1))
    with open(os.path.join(folder, "commands.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join(commands) + "\n")


if __name__ == "__main__":
    main()
