# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Names and documentation comments of C#."""

import re

from texts import parts, translated, wrap

# Task of System.Threading.Tasks is in every second file of C#.
CLASSES = {"Task": "JalonTask"}
# Native bytes that the collector is told of; coordinates are 24 bytes a point.
FACTORS = {"Cloud": "Bytes(box)"}
KEYWORDS = {"params", "out", "in", "ref", "object", "string", "event", "class", "base", "operator", "checked", "fixed"}


def pascal(name):
    return "".join(part[:1].upper() + part[1:] for part in name.lower().split("_"))


def camel(name):
    text = pascal(name)
    text = text[:1].lower() + text[1:]
    return "@" + text if text in KEYWORDS else text


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def in_csharp(text, known):
    """The comment with C#'s names; the error classes are documented by their statuses' names."""
    text = re.sub(r"JALON_ERROR_CANCELLED", "OperationCanceledException", text)
    text = re.sub(r"JALON_ERROR_OUT_OF_MEMORY", "NativeMemoryException", text)
    text = re.sub(r"JALON_ERROR_IO", "FileAccessException", text)
    text = re.sub(r"JALON_ERROR_FORMAT", "FileFormatException", text)
    text = re.sub(r"JALON_ERROR_([A-Z_]+)", lambda m: pascal(m.group(1)) + "Exception", text)
    text = re.sub(r"JALON_([A-Z0-9_]+)(?= \.\.\.|\b)", lambda m: pascal(m.group(1)), text)
    text = translated(text, known, "null", ".", pascal)
    for native, name in CLASSES.items():
        text = re.sub(r"\b%s\b(?=\.)" % native, name, text)
    return text


def summary(text, indent, known=None):
    """A documentation comment of its first sentence, the rest as remarks."""
    if known is not None:
        text = in_csharp(text, known)
    text = escaped(text.strip())
    if not text:
        return []
    (_, first), *rest = parts(text)
    lines = wrap(first, 110, indent + "/// ")
    out = [indent + "/// <summary>"] + [line.rstrip() for line in lines] + [indent + "/// </summary>"]
    if rest:
        out.append(indent + "/// <remarks>")
        for is_table, part in rest:
            tag = "code" if is_table else "para"
            lines = wrap(part, 110, indent + "/// ")
            out += [indent + "/// <%s>" % tag] + lines + [indent + "/// </%s>" % tag]
        out.append(indent + "/// </remarks>")
    return out


def documentation(m, known, has_task):
    text = m.doc or pascal(m.name) + "."
    for i in m.inputs:
        if "_" in i.name and i.kind not in ("task", "options"):
            text = re.sub(r"\b%s\b" % i.name, camel(i.name), text)
    out = summary(text, "", known)
    if m.operation:
        out.append('/// <param name="options">%sOptions, or null for the defaults.</param>' % pascal(m.operation))
    if has_task:
        out += ['/// <param name="progress">Told how far the call is; may be null.</param>',
                '/// <param name="task">Threads, log and progress of several calls, instead of the other two.</param>',
                '/// <param name="cancel">Cancels the call.</param>']
    return out
