# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds from and to files through the C API: just what check_laspy.py and check_e57.py need."""

import ctypes

import numpy

TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "i8", 8: "u8", 9: "f4", 10: "f8"}
CODES = {numpy.dtype(name): code for code, name in TYPES.items()}


class View(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("count", ctypes.c_uint64), ("components", ctypes.c_uint32),
                ("type", ctypes.c_int32), ("stride_bytes", ctypes.c_uint64)]


class Info(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_uint32), ("type", ctypes.c_int32), ("components", ctypes.c_uint32),
                ("reserved", ctypes.c_uint32), ("count", ctypes.c_uint64), ("name", ctypes.c_char_p),
                ("unit", ctypes.c_char_p), ("meaning", ctypes.c_char_p)]


def array_of(view):
    """A copy, (count, components)."""
    dtype = numpy.dtype(TYPES[view.type])
    shape = (view.count, view.components)
    if view.count == 0:
        return numpy.zeros(shape, dtype)
    raw = (ctypes.c_char * (view.stride_bytes * view.count)).from_address(view.data)
    return numpy.ndarray(shape, dtype, raw, strides=(view.stride_bytes, dtype.itemsize)).copy()


class Jalon:
    def __init__(self, library):
        self.lib = ctypes.CDLL(library)
        self.lib.jalon_last_error_message.restype = ctypes.c_char_p
        for name in ("jalon_cloud_release", "jalon_fields_release", "jalon_params_release"):
            getattr(self.lib, name).restype = None

    def call(self, name, *arguments):
        if getattr(self.lib, name)(*arguments) != 0:
            raise RuntimeError("%s: %s" % (name, self.lib.jalon_last_error_message().decode()))

    def has_laz(self):
        """Whether the library was built with the optional codecs."""
        info, count = (ctypes.c_char_p * 3)(), ctypes.c_uint64()
        self.call("jalon_format_count", ctypes.byref(count))
        for i in range(count.value):
            self.call("jalon_format_info", ctypes.c_uint64(i), *(ctypes.byref(info, 8 * k) for k in range(3)))
            if info[0] == b"LAZ":
                return bool(info[2])
        return False

    def read(self, path, box=(), spacing_m=0.0):
        """(coordinates, {name: values}, CRS text)"""
        cloud, fields, view, crs = ctypes.c_void_p(), ctypes.c_void_p(), View(), ctypes.c_char_p()
        options = ctypes.c_void_p()
        self.call("jalon_params_create", b"read", ctypes.byref(options))
        self.call("jalon_params_set_doubles", options, b"box", (ctypes.c_double * len(box))(*box), ctypes.c_uint64(len(box)))
        self.call("jalon_params_set_double", options, b"spacing_m", ctypes.c_double(spacing_m))
        self.call("jalon_cloud_read", str(path).encode(), options, None, ctypes.byref(cloud))
        self.lib.jalon_params_release(options)
        self.call("jalon_cloud_points", cloud, ctypes.byref(view))
        xyz = array_of(view)
        self.call("jalon_cloud_crs", cloud, ctypes.byref(crs))
        text = crs.value.decode()
        self.call("jalon_cloud_fields", cloud, ctypes.byref(fields))
        count, out = ctypes.c_uint64(), {}
        self.call("jalon_fields_count", fields, ctypes.byref(count))
        for i in range(count.value):
            info = Info(struct_size=ctypes.sizeof(Info))
            self.call("jalon_fields_info", fields, ctypes.c_uint64(i), ctypes.byref(info))
            self.call("jalon_fields_view", fields, info.name, ctypes.byref(view))
            values = array_of(view)
            out[info.name.decode()] = values[:, 0] if view.components == 1 else values
        self.lib.jalon_fields_release(fields)
        self.lib.jalon_cloud_release(cloud)
        return xyz, out, text

    def write(self, path, xyz, fields, version, pose=None, crs=None):
        """pose: of the one station, (3, 4), or None for no station."""
        cloud, options = ctypes.c_void_p(), ctypes.c_void_p()
        xyz = numpy.ascontiguousarray(xyz, "f8")
        self.call("jalon_cloud_create", xyz.ctypes.data_as(ctypes.c_void_p), 10, ctypes.c_uint64(len(xyz)),
                  ctypes.c_uint64(0), ctypes.c_uint32(0), ctypes.byref(cloud))
        for name, values in fields.items():
            packed = numpy.ascontiguousarray(values)
            components = 1 if packed.ndim == 1 else packed.shape[1]
            self.call("jalon_cloud_set_field", cloud, name.encode(), packed.ctypes.data_as(ctypes.c_void_p),
                      CODES[packed.dtype], ctypes.c_uint32(components), ctypes.c_uint64(len(packed)),
                      ctypes.c_uint64(0), None, None)
        if pose is not None:
            self.call("jalon_cloud_set_station", cloud, b"S", (ctypes.c_double * 12)(*numpy.ravel(pose)))
        if crs is not None:
            self.call("jalon_cloud_set_crs", cloud, crs.encode())
        self.call("jalon_params_create", b"write", ctypes.byref(options))
        self.call("jalon_params_set_string", options, b"las_version", version.encode())
        self.call("jalon_cloud_write", cloud, str(path).encode(), options, None)
        self.lib.jalon_params_release(options)
        self.lib.jalon_cloud_release(cloud)
