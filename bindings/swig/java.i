/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Java: package org.jalon. 64-bit counts are long, texts cross as UTF-8 bytes (JNI's own strings are not UTF-8), arrays are
 * Java arrays or NIO buffers, failures are subclasses of JalonException. What is generated for Java alone - comments, typed
 * setters, results as values - stands in java_api.i. */
%{
#include "java_support.h"
#include "java_task.h"
%}

%feature("compactdefaultargs"); // java_api.i has the forms without them
%rename("%(lowercamelcase)s", %$isfunction) "";
%rename(isClosed) closed;
/* The classes of these names are written in Java; what SWIG writes is theirs alone. */
%rename(NativeArray) Array;
%rename(NativeGauge) Gauge;
%rename(NativeTargets) Targets;
%rename(NativeCloudList) CloudList;
%typemap(javaclassmodifiers) SWIGTYPE "public final class"
%typemap(javaclassmodifiers) Params "public class"
%typemap(javaclassmodifiers) Array, Gauge, Targets, CloudList "final class"

%apply long long { int64_t, uint64_t, const int64_t&, const uint64_t& };

%pragma(java) jniclassclassmodifiers="final class"
%pragma(java) jniclasscode=%{
  static {
    NativeLibrary.load();
  }
%}

%exception {
  try {
    $action
  } catch (...) {
    jalon_java::raise_failure(jenv, jalon_binding::current_failure());
    return $null;
  }
}

/* Lifetimes: the C++ box lives as long as the Java object, so that a call after close() finds it and is refused. */
%typemap(javabase) SWIGTYPE "NativeObject"
%typemap(javafinalize) SWIGTYPE ""
%typemap(javadestruct, methodname="delete", methodmodifiers="private") SWIGTYPE ""
%typemap(javadestruct, methodname="close", methodmodifiers="public") Array, Gauge, Targets, CloudList {
    freeNow();
  }
%typemap(javabody) SWIGTYPE %{
  private final long swigCPtr;

  $javaclassname(long pointer, boolean owned) {
    swigCPtr = pointer;
    whenGone(() -> $imclassname.delete_$javaclassname(pointer));
  }

  static long getCPtr($javaclassname object) {
    return object == null ? 0 : object.swigCPtr;
  }
%}

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
%typemap(jni) Texts "jbyteArray"
%typemap(jtype) Texts "byte[]"
%typemap(jstype) Texts "java.util.List<String>"
%typemap(out) Texts { $result = jalon_java::bytes_of(jenv, jalon_binding::block_of($1)); }
%typemap(javaout) Texts { return Text.listOf($jnicall); }

/* Arrays in, described by class Rows; null is no array. The overloads of java_api.i take primitive arrays and buffers. */
%typemap(jni) const ArrayIn* "jobject"
%typemap(jtype) const ArrayIn* "Rows"
%typemap(jstype) const ArrayIn* "Rows"
%typemap(javain) const ArrayIn* "$javainput"
%typemap(in) const ArrayIn* (jalon_java::Elements elements) {
  if (!elements.take(jenv, $input, &$1)) return $null;
}

/* Lists: made for the call from what the Java object holds. */
%typemap(jtype, nopgcpp="1") Gauge*, Targets*, CloudList* "long"
%typemap(jstype) Gauge* "Gauge"
%typemap(javain, pre="    final NativeGauge native_$javainput = Gauge.made($javainput);",
         post="      NativeObject.free(native_$javainput);") Gauge* "NativeGauge.getCPtr(native_$javainput)"
%typemap(jstype) Targets* "Targets"
%typemap(javain, pre="    final NativeTargets native_$javainput = Targets.made($javainput);",
         post="      NativeObject.free(native_$javainput);") Targets* "NativeTargets.getCPtr(native_$javainput)"
%typemap(jstype) CloudList* "java.util.List<Cloud>"
%typemap(javain, pre="    final NativeCloudList native_$javainput = NativeObject.listOf($javainput);",
         post="      NativeObject.free(native_$javainput);") CloudList* "NativeCloudList.getCPtr(native_$javainput)"

/* Small arrays of doubles out. */
%typemap(jni) Numbers* "jdoubleArray"
%typemap(jtype) Numbers* "double[]"
%typemap(jstype) Numbers* "double[]"
%typemap(out) Numbers* { $result = jalon_java::doubles_of(jenv, $1); }
%typemap(javaout) Numbers* { return $jnicall; }

/* Bytes out: a Java array, which ends at 2^31 - 1 of them. */
%typemap(jni) Octets* "jbyteArray"
%typemap(jtype) Octets* "byte[]"
%typemap(jstype) Octets* "byte[]"
%typemap(out) Octets* { $result = jalon_java::octets_of(jenv, $1); }
%typemap(javaout) Octets* { return $jnicall; }

/* Large ones: class Array, whose memory direct buffers show. */
%typemap(jstype) Array* "Array"
%typemap(javaout) Array* { return Array.of($jnicall); }
%typemap(in, numinputs=0) JNIEnv* env { $1 = jenv; }
%typemap(jni) jobject direct_buffer "jobject"
%typemap(jtype) jobject direct_buffer "java.nio.ByteBuffer"
%typemap(jstype) jobject direct_buffer "java.nio.ByteBuffer"
%typemap(out) jobject direct_buffer { $result = $1; }
%typemap(javaout) jobject direct_buffer { return $jnicall; }
%extend Array {
  jobject direct_buffer(JNIEnv* env, uint64_t first, uint64_t items) {
    return jalon_java::buffer_of(env, *$self, first, items);
  }
}

/* Listeners of a task. Java holds them, native code sees them while a call runs. */
%javamethodmodifiers Task::hear "private"
%extend Task {
  void hear(JNIEnv* env, jobject progress, jobject log) { jalon_java::listen(env, *$self, progress, log); }
}
%typemap(javacode) Task %{
  private ProgressListener progress; // held here: native code refers to them weakly, so that no cycle keeps this task
  private LogListener log;

  /** Who hears the progress of the next calls with this task; null = nobody. Between calls only. */
  public synchronized Task onProgress(ProgressListener listener) {
    hear(listener, log);
    progress = listener;
    return this;
  }

  /** Who hears the log of the next calls with this task; null = nobody. Between calls only. */
  public synchronized Task onLog(LogListener listener) {
    hear(progress, listener);
    log = listener;
    return this;
  }
%}

%extend Params {
%proxycode %{
  /** Sets a number. {@link NotFoundException} for an unknown name, {@link InvalidArgumentException} for a wrong value. */
  public Params set(String name, double value) {
    setDouble(name, value);
    return this;
  }

  /** Sets a whole number; also where the parameter is a double. */
  public Params set(String name, long value) {
    setInt64(name, value);
    return this;
  }

  /** Sets a switch. */
  public Params set(String name, boolean value) {
    setBool(name, value);
    return this;
  }

  /** Sets a text or a choice. */
  public Params set(String name, String value) {
    setString(name, value);
    return this;
  }

  /** Sets an array. */
  public Params set(String name, double[] values) {
    setDoubles(name, values);
    return this;
  }

  /** The names of the parameters, in the order of the table. */
  public java.util.List<String> names() {
    final java.util.List<String> names = new java.util.ArrayList<>();
    for (long i = 0; i < count(); ++i) {
      names.add(info(i).name());
    }
    return names;
  }
%}
}

%extend Fields {
%proxycode %{
  /** The names of the columns. */
  public java.util.List<String> names() {
    final java.util.List<String> names = new java.util.ArrayList<>();
    for (long i = 0; i < count(); ++i) {
      names.add(info(i).name());
    }
    return names;
  }

  /** A copy of the column as doubles, whatever its type, row by row. */
  public double[] doubles(String name) {
    try (Array column = view(name)) {
      return column.toDoubles();
    }
  }
%}
}

%extend Cloud {
%proxycode %{
  /** As {@link #crop(boolean[], Task)}. */
  public CloudCropResult crop(boolean[] mask) {
    return crop(mask, null);
  }

  /**
   * The points for which the mask is true, and the others, as clouds of their own.
   *
   * <p>mask: one a point; {@link InvalidArgumentException} for another number of them.
   */
  public CloudCropResult crop(boolean[] mask, Task task) {
    return new CloudCropResult(select(mask, task), () -> select(Masks.inverted(mask), task));
  }
%}
}

%include "java_api.i"
