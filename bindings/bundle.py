#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""libjalon and the libraries that it needs, in one folder that stands alone: bundle.py LIBRARY FOLDER LICENCES PATCHELF LIST

What every Linux system has (the C and C++ run times) stays there. The others get names of their own, made of their contents:
a host that has loaded another build under the usual name (an add-in with its own libccd, say, which may be the one for single
precision) and Jalon do not meet. Each is looked for beside the file that needs it. LIST gets the names, what is needed first.
"""

import glob
import hashlib
import os
import re
import shutil
import subprocess
import sys

# From the system come the C library, its loader, the C++ run time, and the run times of the sanitizers in a build that has them.
OF_THE_SYSTEM = re.compile(r"(libc|libm|libdl|librt|libpthread|libstdc\+\+|libgcc_s|libasan|libubsan|libtsan|ld-linux[-\w]*)\.so(\.\d+)*$")


def output_of(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


class Bundle:
    def __init__(self, folder, licences, patchelf):
        self.folder, self.patchelf = folder, patchelf
        self.licensed = set(re.findall(r"^== (lib\w+)", open(licences, encoding="utf-8").read(), re.MULTILINE))
        self.names = []  # of the files that are there, what is needed first
        self.private_names = {}  # {usual name: name in the folder}

    def needed(self, path):
        return [n for n in output_of(self.patchelf, "--print-needed", path).split() if not OF_THE_SYSTEM.match(n)]

    def found(self, path):
        """{name: path} as the system's loader finds what this file needs."""
        return dict(re.findall(r"^\s*(\S+) => (/\S+)", output_of("ldd", path), re.MULTILINE))

    def take(self, path, name, known=None):
        """Copies the file under this name, what it needs before it."""
        known = known or self.found(path)
        copied = os.path.join(self.folder, name)
        changes = []
        for other in self.needed(path):
            if other not in self.private_names:
                self.private_names[other] = self.private_name(other, known[other])
                self.take(known[other], self.private_names[other], known)
            changes += ["--replace-needed", other, self.private_names[other]]
        shutil.copyfile(path, copied)
        os.chmod(copied, 0o755)
        for options in (changes, ["--set-soname", name], ["--force-rpath", "--set-rpath", "$ORIGIN"]):  # together they get mixed up
            if options:
                subprocess.run([self.patchelf, *options, copied], check=True)
        self.names.append(name)

    def private_name(self, name, path):
        stem, rest = name.split(".", 1)
        if stem not in self.licensed:
            sys.exit("bundle.py: the licence of %s is missing in the list of licences" % stem)
        with open(path, "rb") as file:
            return "%s-%s.%s" % (stem, hashlib.sha256(file.read()).hexdigest()[:8], rest)


def main():
    library, folder, licences, patchelf, names = sys.argv[1:6]
    os.makedirs(folder, exist_ok=True)
    for old in glob.glob(os.path.join(folder, "lib*-????????.so.*")) + glob.glob(os.path.join(folder, "libjalon.so*")):
        os.remove(old)
    bundle = Bundle(folder, licences, patchelf)
    bundle.take(library, output_of(patchelf, "--print-soname", library).strip())
    with open(names, "w", encoding="utf-8") as file:
        file.write("".join(name + "\n" for name in bundle.names))


if __name__ == "__main__":
    main()
