#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The folders of the package as one file that NuGet reads: pack.py FOLDER OUT.nupkg (nuget pack, without nuget)."""

import os
import sys
import zipfile

TYPES = {"dll": "application/octet", "so": "application/octet", "xml": "application/octet", "md": "application/octet",
         "targets": "application/octet", "nuspec": "application/octet", "rels": "application/vnd.openxmlformats-package.relationships+xml"}
RELATION = "http://schemas.microsoft.com/packaging/2010/07/manifest"
DATE = (1980, 1, 1, 0, 0, 0)  # the first that zip can hold: the same files give the same package


def content_types(names):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">']
    lines += ['<Default Extension="%s" ContentType="%s" />' % item for item in sorted(TYPES.items())]
    known = [n for n in names if n.rsplit(".", 1)[-1] not in TYPES]
    return "\n".join(lines + ['<Override PartName="/%s" ContentType="application/octet" />' % n for n in known] + ["</Types>", ""])


def relations(nuspec):
    return ('<?xml version="1.0" encoding="utf-8"?>\n<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">\n'
            '<Relationship Type="%s" Target="/%s" Id="R1" />\n</Relationships>\n' % (RELATION, nuspec))


def files(folder):
    for where, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(where, name)
            yield os.path.relpath(path, folder).replace(os.sep, "/"), path


def main():
    folder, out = sys.argv[1:3]
    found = [(name, path) for name, path in files(folder) if not name.endswith(".nupkg")]
    nuspec = next(name for name, _ in found if name.endswith(".nuspec"))
    names = [name for name, _ in found]
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as package:
        for name, text in (("[Content_Types].xml", content_types(names)), ("_rels/.rels", relations(nuspec))):
            package.writestr(zipfile.ZipInfo(name, DATE), text)
        for name, path in found:
            with open(path, "rb") as f:
                info = zipfile.ZipInfo(name, DATE)
                info.compress_type = zipfile.ZIP_DEFLATED
                package.writestr(info, f.read())


if __name__ == "__main__":
    main()
