/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Python: jalon._native, which the generated jalon/_api.py gives its classes, keyword arguments and texts. */
%{
#include "python_support.h"
%}
%init %{
  if (!jalon_python::ready()) return NULL;
%}

%feature("compactdefaultargs");

/* The interpreter is free during every call; a failure becomes the class that jalon/_errors.py has for its status. */
%exception {
  try {
    jalon_python::Unlocked unlocked;
    $action
  } catch (...) {
    jalon_python::raise_failure(jalon_binding::current_failure());
    SWIG_fail;
  }
}

%typemap(in) const ArrayIn* (jalon_python::Buffer buffer) {
  if (!buffer.take($input, &$1)) SWIG_fail;
}
%typemap(out) Array* {
  $result = jalon_python::view_of_array($1);
}
%apply Array* { Numbers*, Octets* };

%typemap(in) Task* task (jalon_python::CallTask call) {
  void* given = nullptr;
  if (SWIG_IsOK(SWIG_ConvertPtr($input, &given, $1_descriptor, 0)) && given != nullptr) {
    $1 = static_cast<Task*>(given);
  } else {
    if (!call.make($input)) SWIG_fail;
    $1 = call.task();
  }
}

%typemap(out) std::string {
  $result = PyUnicode_DecodeUTF8($1.data(), static_cast<Py_ssize_t>($1.size()), "surrogateescape");
}
%typemap(out) Texts {
  $result = PyList_New(0);
  for (const std::string& text : $1) {
    PyObject* item = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape");
    const bool is_added = $result != NULL && item != NULL && PyList_Append($result, item) == 0;
    Py_XDECREF(item);
    if (!is_added) {
      Py_CLEAR($result);
      SWIG_fail;
    }
  }
}
%typemap(in) const char* (jalon_python::Text text) {
  if (!text.take($input, &$1)) SWIG_fail;
}
%typemap(freearg) const char* "";

%{
static void set_errors(PyObject* classes) { jalon_python::set_errors(classes); }
static void set_callbacks(Task* box, PyObject* progress, PyObject* log) { jalon_python::set_callbacks(box, progress, log); }
%}
%exception set_errors { $action }
%exception set_callbacks {
  try {
    $action
  } catch (...) {
    jalon_python::raise_failure(jalon_binding::current_failure());
    SWIG_fail;
  }
}
void set_errors(PyObject* classes);
void set_callbacks(Task* box, PyObject* progress, PyObject* log);
