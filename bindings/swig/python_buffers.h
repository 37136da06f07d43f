/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Arrays through Python's buffer protocol: no NumPy needed, none refused. */
#ifndef JALON_BINDINGS_PYTHON_BUFFERS_H
#define JALON_BINDINGS_PYTHON_BUFFERS_H

#include <Python.h>

#include "jalon_calls.h"

namespace jalon_python {

using jalon_binding::Array;
using jalon_binding::ArrayIn;

/**
 * The element type of a struct-module format; 0 for one that no array of Jalon has: truth values ('?') are masks and
 * characters ('c') texts, not numbers. Native byte order only.
 */
inline std::int32_t type_of_format(const char* format, Py_ssize_t size) {
  if (format == nullptr) return JALON_UINT8;
  if (*format == '@' || *format == '=') ++format;
#if PY_LITTLE_ENDIAN
  if (*format == '<') ++format;
#else
  if (*format == '>' || *format == '!') ++format;
#endif
  if (format[0] == '\0' || format[1] != '\0') return 0;
  const bool is_signed = std::strchr("bhilqn", format[0]) != nullptr;
  if (is_signed || std::strchr("BHILQN", format[0]) != nullptr) {
    switch (size) {
      case 1:
        return is_signed ? JALON_INT8 : JALON_UINT8;
      case 2:
        return is_signed ? JALON_INT16 : JALON_UINT16;
      case 4:
        return is_signed ? JALON_INT32 : JALON_UINT32;
      case 8:
        return is_signed ? JALON_INT64 : JALON_UINT64;
      default:
        return 0;
    }
  }
  if (format[0] == 'f' && size == 4) return JALON_FLOAT32;
  return format[0] == 'd' && size == 8 ? JALON_FLOAT64 : 0;
}

inline const char* format_of_type(std::int32_t type) {
  static const char* const formats[] = {"", "b", "B", "h", "H", "i", "I", "q", "Q", "f", "d"};
  return formats[type];
}

/** An argument that is an array: anything with a buffer, held until the call has ended. None is no array. */
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() {
    if (held_) PyBuffer_Release(&view_);
  }

  bool take(PyObject* object, ArrayIn** to) {
    *to = nullptr;
    if (object == Py_None) return true;
    if (PyObject_GetBuffer(object, &view_, PyBUF_RECORDS_RO) != 0) {
      PyErr_Format(PyExc_TypeError, "an array is needed, not %s", Py_TYPE(object)->tp_name);
      return false;
    }
    held_ = true;
    array_.type = type_of_format(view_.format, view_.itemsize);
    if (array_.type == 0) {
      PyErr_Format(
          PyExc_TypeError,
          "arrays of format '%s' are not taken: numbers of 8 to 64 bits in native byte order are",
          view_.format);
      return false;
    }
    if (!lay_out()) return false;
    *to = &array_;
    return true;
  }
  bool take(PyObject* object, const ArrayIn** to) {
    return take(object, const_cast<ArrayIn**>(to));
  }

 private:
  /** Items along the first axis; the others must be side by side, else one packed copy is made. */
  bool lay_out() {
    array_.data = view_.buf;
    array_.count = view_.ndim == 0 ? 1 : static_cast<std::uint64_t>(view_.shape[0]);
    std::uint64_t components = 1;
    bool side_by_side = true;
    Py_ssize_t step = view_.itemsize;
    for (int axis = view_.ndim - 1; axis >= 1; --axis) {
      side_by_side = side_by_side && (view_.shape[axis] < 2 || view_.strides[axis] == step);
      step *= view_.shape[axis];
      components *= static_cast<std::uint64_t>(view_.shape[axis]);
    }
    if (components > UINT32_MAX) {
      PyErr_SetString(PyExc_ValueError, "an array with more than 2^32 - 1 elements an item");
      return false;
    }
    array_.components = static_cast<std::uint32_t>(components);
    array_.flat = view_.ndim < 2;
    const Py_ssize_t stride = view_.ndim == 0 ? view_.itemsize : view_.strides[0];
    array_.stride_bytes = static_cast<std::uint64_t>(stride);
    if (array_.count < 2) array_.stride_bytes = static_cast<std::uint64_t>(step);
    if (!side_by_side || (array_.count > 1 && stride < step)) return copy(step);
    return true;
  }
  bool copy(Py_ssize_t item_bytes) {
    try {
      copy_.resize(static_cast<std::size_t>(view_.len) + 1);
    } catch (const std::exception&) {  // out of memory, or more than any memory
      PyErr_NoMemory();
      return false;
    }
    if (PyBuffer_ToContiguous(copy_.data(), &view_, view_.len, 'C') != 0) return false;
    array_.data = copy_.data();
    array_.stride_bytes = static_cast<std::uint64_t>(item_bytes);
    return true;
  }

  Py_buffer view_ = {};
  bool held_ = false;
  ArrayIn array_;
  std::vector<char> copy_;
};

/** What stands behind the memoryviews that results are: it owns the array, which owns a share of the C handle. */
struct Exporter {
  PyObject_HEAD Array* array;
  Py_ssize_t shape[2], strides[2];
};

inline int get_buffer(PyObject* self, Py_buffer* view, int flags) {
  Exporter* exporter = reinterpret_cast<Exporter*>(self);
  const Array& array = *exporter->array;
  const Py_ssize_t size = static_cast<Py_ssize_t>(jalon_binding::size_of_type(array.type()));
  static char nothing[8];
  if ((flags & PyBUF_WRITABLE) == PyBUF_WRITABLE) {
    PyErr_SetString(PyExc_BufferError, "arrays of Jalon are read-only");
    return -1;
  }
  view->buf = array.data() == nullptr ? nothing : const_cast<void*>(array.data());
  view->obj = self;
  Py_INCREF(self);
  view->itemsize = size;
  view->len = exporter->shape[0] * exporter->shape[1] * size;
  view->readonly = 1;
  view->ndim = array.components() == 1 ? 1 : 2;
  view->format = const_cast<char*>(format_of_type(array.type()));
  view->shape = exporter->shape;
  view->strides = exporter->strides;
  view->suboffsets = nullptr;
  view->internal = nullptr;
  return 0;
}

inline void free_exporter(PyObject* self) {
  delete reinterpret_cast<Exporter*>(self)->array;
  Py_TYPE(self)->tp_free(self);
}

inline PyBufferProcs& exporter_procs() {
  static PyBufferProcs procs = {get_buffer, nullptr};
  return procs;
}
inline PyTypeObject& exporter_type() {
  static PyTypeObject type = {PyVarObject_HEAD_INIT(nullptr, 0)};
  return type;
}
inline bool ready() {
  PyTypeObject& type = exporter_type();
  type.tp_name = "jalon._native.ArrayOwner";
  type.tp_basicsize = sizeof(Exporter);
  type.tp_dealloc = free_exporter;
  type.tp_as_buffer = &exporter_procs();
  type.tp_flags = Py_TPFLAGS_DEFAULT;
  type.tp_doc = "Keeps the memory of an array alive.";
  return PyType_Ready(&type) == 0;
}

/** A read-only memoryview of the array, which is taken over. Nothing is copied. */
inline PyObject* view_of_array(Array* array) {
  std::unique_ptr<Array> taken(array);
  if (array->count() > static_cast<std::uint64_t>(PY_SSIZE_T_MAX) / 64) {
    PyErr_SetString(PyExc_MemoryError, "the array is larger than this Python can address");
    return nullptr;
  }
  Exporter* exporter = PyObject_New(Exporter, &exporter_type());
  if (exporter == nullptr) return nullptr;
  exporter->array = taken.release();
  exporter->shape[0] = static_cast<Py_ssize_t>(array->count());
  exporter->shape[1] = static_cast<Py_ssize_t>(array->components());
  exporter->strides[0] = static_cast<Py_ssize_t>(array->stride_bytes());
  exporter->strides[1] = static_cast<Py_ssize_t>(jalon_binding::size_of_type(array->type()));
  PyObject* view = PyMemoryView_FromObject(reinterpret_cast<PyObject*>(exporter));
  Py_DECREF(exporter);
  return view;
}

}  // namespace jalon_python

#endif
