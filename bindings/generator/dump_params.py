#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The parameter tables of a built library as JSON: dump_params.py LIBRARY OUT

{"operations": {"normals": [row, ...]}, "workers": {"segmenter": {"ransac": [row, ...]}}}; workers are the nouns with a function
_methods, which lists theirs, the default first.
"""

import ctypes
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from headers import nouns, public_functions, structs  # noqa: E402

NUMBERS = {"uint32_t": ctypes.c_uint32, "int32_t": ctypes.c_int32, "uint64_t": ctypes.c_uint64, "double": ctypes.c_double,
           "const char*": ctypes.c_char_p}


class Info(ctypes.Structure):
    _fields_ = [(field, NUMBERS[type_]) for type_, field, _, _ in structs()["jalon_param_info"]]


class Library:
    def __init__(self, path):
        self.c = ctypes.CDLL(path)
        self.c.jalon_last_error_message.restype = ctypes.c_char_p

    def check(self, status):
        if status != 0:
            raise SystemExit(self.c.jalon_last_error_message().decode())

    def rows(self, params):
        count = ctypes.c_uint64()
        self.check(self.c.jalon_params_count(params, ctypes.byref(count)))
        found = []
        for i in range(count.value):
            info = Info()
            info.struct_size = ctypes.sizeof(Info)
            self.check(self.c.jalon_params_info(params, ctypes.c_uint64(i), ctypes.byref(info)))
            row = {field: getattr(info, field) for field, _ in Info._fields_ if field != "struct_size"}
            for key, value in row.items():
                if isinstance(value, bytes):
                    row[key] = value.decode("utf-8")
                elif isinstance(value, float) and value in (float("inf"), float("-inf")):
                    row[key] = None
            found.append(row)
        self.c.jalon_params_release(params)
        return found

    def operations(self):
        count, found = ctypes.c_uint64(), {}
        self.check(self.c.jalon_params_operation_count(ctypes.byref(count)))
        for i in range(count.value):
            name, params = ctypes.c_char_p(), ctypes.c_void_p()
            self.check(self.c.jalon_params_operation_name(ctypes.c_uint64(i), ctypes.byref(name)))
            self.check(self.c.jalon_params_create(name, ctypes.byref(params)))
            found[name.value.decode()] = self.rows(params)
        return found

    def methods(self, noun):
        names, count, found = ctypes.POINTER(ctypes.c_char_p)(), ctypes.c_uint64(), {}
        self.check(getattr(self.c, noun + "_methods")(ctypes.byref(names), ctypes.byref(count)))
        for name in names[:count.value]:
            worker, params = ctypes.c_void_p(), ctypes.c_void_p()
            self.check(getattr(self.c, noun + "_create")(name, ctypes.byref(worker)))
            self.check(getattr(self.c, noun + "_params")(worker, ctypes.byref(params)))
            found[name.decode()] = self.rows(params)
            getattr(self.c, noun + "_release")(worker)
        return found


def workers():
    listed = {f.name for f in public_functions()}
    return [n for n in sorted(nouns()) if n + "_methods" in listed]


def main():
    library = Library(sys.argv[1])
    tables = {"operations": library.operations(),
              "workers": {n[len("jalon_"):]: library.methods(n) for n in workers()}}
    with open(sys.argv[2], "w", encoding="utf-8") as f:
        json.dump(tables, f, indent=1, ensure_ascii=False)


if __name__ == "__main__":
    main()
