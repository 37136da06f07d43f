/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* C#: only the P/Invoke class is taken from SWIG; the public classes stand in Api.cs, generated from the headers. Objects
 * and texts cross as addresses that managed code holds during the call: no object of the collector is in the marshaller's hands,
 * where Mono with its hybrid suspension may move it. A failure is kept per thread and thrown by managed
 * code after the call (no callbacks into the runtime); texts cross as UTF-8. */
%{
#include "csharp_support.h"
%}

%feature("compactdefaultargs");

%feature("except", canthrow="1") {
  try {
    $action
  } catch (...) {
    jalon_csharp::keep_failure(jalon_binding::current_failure());
    return $null;
  }
}

/* What csharp_support.h exports beside the wrapped functions. */
%pragma(csharp) imclasscode=%{
  [global::System.Runtime.InteropServices.DllImport(Loader.Name, EntryPoint="jalon_csharp_status")]
  public static extern int last_status();
  [global::System.Runtime.InteropServices.DllImport(Loader.Name, EntryPoint="jalon_csharp_take_message")]
  public static extern global::System.IntPtr take_message();
  [global::System.Runtime.InteropServices.DllImport(Loader.Name, EntryPoint="jalon_csharp_array")]
  public static extern global::System.IntPtr borrow_array(global::System.IntPtr data, int type, ulong count,
                                                          uint components, ulong stride_bytes);
  [global::System.Runtime.InteropServices.DllImport(Loader.Name, EntryPoint="jalon_csharp_array_free")]
  public static extern void free_array(global::System.IntPtr array);
  [global::System.Runtime.InteropServices.DllImport(Loader.Name, EntryPoint="jalon_csharp_callbacks")]
  public static extern void set_callbacks(global::System.IntPtr task, Callbacks.NativeProgress progress, Callbacks.NativeLog log,
                                          global::System.IntPtr user);
%}

%apply long long { int64_t };
%apply unsigned long long { uint64_t };

/* Objects. */
%typemap(imtype) SWIGTYPE* "global::System.IntPtr"

/* Texts. */
%typemap(ctype) const char* "const char*"
%typemap(imtype) const char* "global::System.IntPtr"
%typemap(in) const char* { $1 = (char*)$input; }
%typemap(freearg) const char* ""
%typemap(ctype) std::string "const char*"
%typemap(imtype) std::string "global::System.IntPtr"
%typemap(out, null="NULL") std::string { $result = jalon_csharp::keep_text(std::move($1)); }
%typemap(ctype) Texts "const char*"
%typemap(imtype) Texts "global::System.IntPtr"
%typemap(out, null="NULL") Texts { $result = jalon_csharp::keep_text(jalon_binding::block_of($1)); }

/* Arrays in: managed arrays, pinned during the call; null is no array. */
%typemap(ctype) const ArrayIn* "const void*"
%typemap(imtype) const ArrayIn* "global::System.IntPtr"
%typemap(in) const ArrayIn* { $1 = ($1_ltype)$input; }

/* Arrays out: their memory as it is; class ArrayView of managed code guards it. */
%typemap(ctype) void* memory_of "void*"
%typemap(imtype) void* memory_of "global::System.IntPtr"
%typemap(out) void* memory_of { $result = $1; }
%extend Array {
  void* memory_of() { return const_cast<void*>($self->data()); }
}
