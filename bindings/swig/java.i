/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Java: package org.jalon. 64-bit counts are long, texts cross as UTF-8 bytes (JNI's own strings are not UTF-8), arrays are
 * Java arrays or NIO buffers, failures are subclasses of JalonException. */
%{
#include "java_support.h"
%}

%rename("%(lowercamelcase)s", %$isfunction) "";

%apply long long { int64_t, uint64_t, const int64_t&, const uint64_t& };

%exception {
  try {
    $action
  } catch (...) {
    jalon_java::raise_failure(jenv, jalon_binding::current_failure());
    return $null;
  }
}

/* Texts. */
%typemap(jni) const char* "jbyteArray"
%typemap(jtype) const char* "byte[]"
%typemap(jstype) const char* "String"
%typemap(javain) const char* "Text.utf8($javainput)"
%typemap(in) const char* (jalon_java::Text text) { $1 = (char*)text.take(jenv, $input); }
%typemap(freearg) const char* ""
%typemap(jni) std::string "jbyteArray"
%typemap(jtype) std::string "byte[]"
%typemap(jstype) std::string "String"
%typemap(out) std::string { $result = jalon_java::bytes_of(jenv, $1); }
%typemap(javaout) std::string { return Text.of($jnicall); }

/* Arrays in: primitive arrays and direct buffers; null is no array. */
%typemap(jni) const ArrayIn* "jobject"
%typemap(jtype) const ArrayIn* "Object"
%typemap(jstype) const ArrayIn* "Object"
%typemap(javain) const ArrayIn* "$javainput"
%typemap(in) const ArrayIn* (jalon_java::Elements elements) {
  if (!elements.take(jenv, $input, &$1)) return $null;
}

/* Small arrays of doubles out. */
%typemap(jni) Numbers* "jdoubleArray"
%typemap(jtype) Numbers* "double[]"
%typemap(jstype) Numbers* "double[]"
%typemap(out) Numbers* { $result = jalon_java::doubles_of(jenv, $1); }
%typemap(javaout) Numbers* { return $jnicall; }

/* Large ones: class Array, whose memory a direct buffer shows. */
%typemap(in, numinputs=0) JNIEnv* env { $1 = jenv; }
%typemap(jni) jobject direct_buffer "jobject"
%typemap(jtype) jobject direct_buffer "java.nio.ByteBuffer"
%typemap(jstype) jobject direct_buffer "java.nio.ByteBuffer"
%typemap(out) jobject direct_buffer { $result = $1; }
%typemap(javaout) jobject direct_buffer { return $jnicall; }
%extend Array {
  jobject direct_buffer(JNIEnv* env) { return jalon_java::buffer_of(env, *$self); }
}
