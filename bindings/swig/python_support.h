/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the Python wrappers need of Python: the interpreter's lock, errors, texts, buffers in, views out, callbacks. */
#ifndef JALON_BINDINGS_PYTHON_SUPPORT_H
#define JALON_BINDINGS_PYTHON_SUPPORT_H

#include <Python.h>

#include "python_buffers.h"

namespace jalon_python {

using jalon_binding::Failure;
using jalon_binding::Handle;

/** Other Python threads run while this lives. */
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) {}
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked() { PyEval_RestoreThread(state_); }

 private:
  PyThreadState* state_;
};

/** The interpreter's lock, for callbacks and whatever else comes from native code. */
class Locked {
 public:
  Locked() : state_(PyGILState_Ensure()) {}
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
  ~Locked() { PyGILState_Release(state_); }

 private:
  PyGILState_STATE state_;
};

/** The exception of a callback, kept until the call that made it has ended. Callbacks come on the calling thread only.
 */
struct Pending {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
};
inline Pending& pending() {
  thread_local Pending kept;
  return kept;
}
inline void keep_exception() {
  Pending& kept = pending();
  if (kept.type != nullptr) {
    PyErr_Clear();
    return;
  }
  PyErr_Fetch(&kept.type, &kept.value, &kept.trace);
  jalon_binding::host_failed() = true;
}

/** {status: class}; 0 is the class of statuses that are not in it. */
inline PyObject*& errors() {
  static PyObject* classes = nullptr;
  return classes;
}
inline void set_errors(PyObject* classes) {
  Py_INCREF(classes);
  Py_XDECREF(errors());
  errors() = classes;
}

inline void raise_failure(const Failure& failure) {
  Pending& kept = pending();
  if (kept.type != nullptr) {
    jalon_binding::host_failed() = false;
    PyErr_Restore(kept.type, kept.value, kept.trace);
    kept = Pending();
    return;
  }
  PyObject* status = PyLong_FromLong(failure.status);
  PyObject* found =
      errors() == nullptr || status == nullptr ? nullptr : PyDict_GetItem(errors(), status);
  Py_XDECREF(status);
  PyObject* text = PyUnicode_DecodeUTF8(failure.message.data(),
                                        static_cast<Py_ssize_t>(failure.message.size()), "replace");
  if (text == nullptr) return;
  PyErr_SetObject(found != nullptr ? found : PyExc_RuntimeError, text);
  Py_DECREF(text);
}

/** A text or a path as UTF-8; None is no text. */
class Text {
 public:
  Text() = default;
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;
  ~Text() { Py_XDECREF(bytes_); }
  bool take(PyObject* object, const char** to) {
    *to = nullptr;
    if (object == Py_None) return true;
    if (!PyUnicode_Check(object)) {
      PyErr_Format(PyExc_TypeError, "a text is needed, not %s", Py_TYPE(object)->tp_name);
      return false;
    }
    bytes_ = PyUnicode_AsEncodedString(object, "utf-8", "surrogateescape");
    if (bytes_ == nullptr) return false;
    if (static_cast<std::size_t>(PyBytes_GET_SIZE(bytes_)) !=
        std::strlen(PyBytes_AS_STRING(bytes_))) {
      PyErr_SetString(PyExc_ValueError, "embedded null character");
      return false;
    }
    *to = PyBytes_AS_STRING(bytes_);
    return true;
  }
  bool take(PyObject* object, char** to) { return take(object, const_cast<const char**>(to)); }

 private:
  PyObject* bytes_ = nullptr;
};

/** The callables of a task, which whoever makes a call with it keeps: Python's task, where its collector sees them. */
struct Callbacks {
  PyObject *progress = nullptr, *log = nullptr;
};

/** Whether an answer is False, Python's own or NumPy's; what is merely false when asked, such as None, is not. */
inline bool says_false(PyObject* answer) {
  const char* type = Py_TYPE(answer)->tp_name;  // "numpy.bool_" up to NumPy 1, "numpy.bool" since 2
  if (std::strcmp(type, "numpy.bool_") != 0 && std::strcmp(type, "numpy.bool") != 0)
    return answer == Py_False;
  return PyObject_IsTrue(answer) == 0;
}

/** Ctrl-C first, then the callable: False cancels, an exception cancels and surfaces as itself. */
inline int32_t on_progress(double fraction, const char* stage, void* user) {
  const Locked locked;
  PyObject* progress = static_cast<Callbacks*>(user)->progress;
  if (pending().type != nullptr) return 1;  // the log raised: no call of progress may take that
  if (PyErr_CheckSignals() != 0) {
    keep_exception();
    return 1;
  }
  if (progress == nullptr) return 0;
  PyObject* answer = PyObject_CallFunction(progress, "ds", fraction, stage);
  const bool stop = answer != nullptr && says_false(answer);
  if (answer == nullptr) keep_exception();
  Py_XDECREF(answer);
  return answer == nullptr || stop ? 1 : 0;
}

inline void on_log(int32_t level, const char* text, void* user) {
  const Locked locked;
  if (pending().type != nullptr) return;
  PyObject* line =
      PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "replace");
  PyObject* answer = line == nullptr ? nullptr
                                     : PyObject_CallFunction(static_cast<Callbacks*>(user)->log,
                                                             "iO", level, line);
  if (answer == nullptr) keep_exception();
  Py_XDECREF(line);
  Py_XDECREF(answer);
}

/** Gives the task these callables (None: none), and the look for Ctrl-C in any case. */
inline void set_callbacks(Handle<jalon_task>* box, PyObject* progress, PyObject* log) {
  auto callbacks = std::make_shared<Callbacks>();
  if (progress != Py_None) callbacks->progress = progress;
  if (log != Py_None) callbacks->log = log;
  const jalon_binding::Use<jalon_task> task(box);
  jalon_binding::check(jalon_task_set_progress(task, on_progress, callbacks.get()));
  jalon_binding::check(
      jalon_task_set_log(task, callbacks->log == nullptr ? nullptr : on_log, callbacks.get()));
  box->host = callbacks;
}

/** The task of one call that was given none: with the callable or None. */
class CallTask {
 public:
  bool make(PyObject* progress) {
    if (progress != Py_None && !PyCallable_Check(progress)) {
      PyErr_Format(PyExc_TypeError, "progress must be callable, not %s",
                   Py_TYPE(progress)->tp_name);
      return false;
    }
    try {
      jalon_binding::Owned<jalon_task> made;
      jalon_binding::check(jalon_task_create(made.slot()));
      box_.reset(jalon_binding::boxed(made));
      set_callbacks(box_.get(), progress, Py_None);
    } catch (...) {
      raise_failure(jalon_binding::current_failure());
      return false;
    }
    return true;
  }
  Handle<jalon_task>* task() const { return box_.get(); }

 private:
  std::unique_ptr<Handle<jalon_task>> box_;
};

}  // namespace jalon_python

#endif
