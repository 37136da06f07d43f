/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* C#: namespace Jalon, free functions in the class Library. A failure is kept per thread and thrown by managed code after the
 * call (no callbacks into the runtime); texts cross as UTF-8. */
%{
#include "csharp_support.h"
%}

%rename("%(camelcase)s", %$isfunction) "";

/* What SWIG's own managed code asks after each call. */
%pragma(csharp) imclasscode=%{
  internal static class SWIGPendingException {
    internal static bool Pending { get { return Status.Pending; } }
    internal static global::System.Exception Retrieve() { return Status.Take(); }
  }
%}

%feature("except", canthrow="1") {
  try {
    $action
  } catch (...) {
    jalon_csharp::keep_failure(jalon_binding::current_failure());
    return $null;
  }
}

%apply long long { int64_t };
%apply unsigned long long { uint64_t };

/* Texts. */
%typemap(ctype) const char* "const char*"
%typemap(imtype) const char* "byte[]"
%typemap(cstype) const char* "string"
%typemap(csin) const char* "Text.Utf8($csinput)"
%typemap(in) const char* { $1 = (char*)$input; }
%typemap(freearg) const char* ""
%typemap(ctype) std::string "const char*"
%typemap(imtype) std::string "global::System.IntPtr"
%typemap(cstype) std::string "string"
%typemap(out, null="NULL") std::string { $result = jalon_csharp::keep_text(std::move($1)); }
%typemap(csout, excode=SWIGEXCODE) std::string {
    var text = $imcall;$excode
    return Text.Of(text);
  }

/* Arrays in: managed arrays, pinned during the call; null is no array. */
%typemap(ctype) const ArrayIn* "const void*"
%typemap(imtype) const ArrayIn* "global::System.IntPtr"
%typemap(cstype) const ArrayIn* "global::System.Array"
%typemap(csin, pre="    using (var pin_$csinput = new Pinned($csinput)) {", terminator="    }") const ArrayIn* "pin_$csinput.Pointer"
%typemap(in) const ArrayIn* { $1 = ($1_ltype)$input; }

/* Small arrays of doubles out. */
%typemap(cstype) Numbers* "double[]"
%typemap(csout, excode=SWIGEXCODE) Numbers* {
    var numbers = $imcall;$excode
    using (var array = new Array(numbers, true)) return array.ToDoubles();
  }
%typemap(cstype) void* memory_of "global::System.IntPtr"
%typemap(imtype) void* memory_of "global::System.IntPtr"
%typemap(csout, excode=SWIGEXCODE) void* memory_of {
    var ret = $imcall;$excode
    return ret;
  }
%extend Array {
  void* memory_of() { return const_cast<void*>($self->data()); }
}
%typemap(cscode) Array %{
  /// <summary>The elements as doubles, row by row; a copy. For arrays of doubles without gaps.</summary>
  public double[] ToDoubles() {
    var values = new double[checked((int)(Count() * Components()))];
    if (values.Length != 0) global::System.Runtime.InteropServices.Marshal.Copy(MemoryOf(), values, 0, values.Length);
    return values;
  }
%}
