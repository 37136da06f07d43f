# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What points a reader somewhere and can be checked: jalon.h names all headers."""

import os
import re

from source import ROOT, read


def umbrella():
    """jalon.h includes every public header, and its comment names every noun that has a method to choose."""
    text = read("include/jalon/jalon.h")
    for header in sorted(os.listdir(os.path.join(ROOT, "include", "jalon"))):
        if header != "jalon.h" and "#include <jalon/%s>" % header not in text:
            yield "jalon.h does not include %s" % header
        for noun in re.findall(r"\bjalon_(\w+)_create\(const char\* method,", read("include/jalon/" + header)):
            if not re.search(r"\b%s\b" % noun, text[:text.index("*/\n#ifndef")]):
                yield "the comment of jalon.h forgets the %s" % noun
