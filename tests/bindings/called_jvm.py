#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Every public member of the Java or C# binding was called with real data and returned: called_jvm.py LANGUAGE FOLDER

FOLDER holds what a run of the tests left: public.txt, the public members of the built package, and called.txt, those of which the
virtual machine itself saw a call return ("Cloud.select(boolean[], Task)"). What the package must have follows from the headers.
"""

import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "style")] + [
    os.path.join(HERE, "..", "..", "bindings", folder) for folder in ("generator", "java")]
from shapes import methods  # noqa: E402
from source import Tally  # noqa: E402


def java_names():
    from overloads import camel
    return {m.c.name: {"%s.%s" % (m.class_name or "Jalon", camel(m.name))} for m in methods()}


def csharp_names():
    """A function is a method, a constructor, or a half of a property."""
    from csharp_inputs import class_name
    from emit_csharp import member_name
    names = {}
    for m in methods():
        owner, name = class_name(m.noun) if m.noun else "Library", member_name(m)
        forms = [name, "get_" + name, name.replace("Set", "set_", 1)] + ([".ctor"] if m.name == "create" else [])
        names[m.c.name] = {owner + "." + form for form in forms}
        if m.name == "params":  # of a worker: its property Parameters
            names[m.c.name].add("Worker.get_Parameters")
    return names


NAMES = {"java": java_names, "csharp": csharp_names}


def lines(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return {line.strip() for line in file if line.strip()}


def main():
    language, folder = sys.argv[1:3]
    tally = Tally()
    public, called = lines(folder, "public.txt"), lines(folder, "called.txt")
    heads = {member.split("(")[0] for member in public}
    functions = NAMES[language]()
    tally.check("called__%s_has_a_member_for_every_function" % language, sorted(c for c, names in functions.items() if not names & heads))
    absent = sorted(public - called)
    tally.check("called__%s_calls_every_public_member_with_real_data" % language, absent)
    print("FIGURE %s: %d of %d public members called, for %d functions of C" % (
        language, len(public) - len(absent), len(public), len(functions)))
    tally.close()


if __name__ == "__main__":
    main()
