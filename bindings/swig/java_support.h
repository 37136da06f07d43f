/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the Java wrappers need of JNI: errors, texts, arrays in and out. */
#ifndef JALON_BINDINGS_JAVA_SUPPORT_H
#define JALON_BINDINGS_JAVA_SUPPORT_H

#include <jni.h>

#include "jalon_calls.h"

namespace jalon_java {

using jalon_binding::Array;
using jalon_binding::ArrayIn;
using jalon_binding::Failure;

inline jbyteArray bytes_of(JNIEnv* env, const std::string& text) {
  const jsize size = static_cast<jsize>(text.size());
  jbyteArray bytes = env->NewByteArray(size);
  if (bytes != nullptr)
    env->SetByteArrayRegion(bytes, 0, size, reinterpret_cast<const jbyte*>(text.data()));
  return bytes;
}

/** JalonException.of(status, message), thrown. */
inline void raise_failure(JNIEnv* env, const Failure& failure) {
  jalon_binding::host_failed() = false;
  if (env->ExceptionCheck()) return;  // what a listener threw is what the caller gets
  jclass type = env->FindClass("org/jalon/JalonException");
  if (type == nullptr) return;
  jmethodID of = env->GetStaticMethodID(type, "of", "(I[B)Lorg/jalon/JalonException;");
  jbyteArray message = of == nullptr ? nullptr : bytes_of(env, failure.message);
  if (message == nullptr) return;
  jobject exception =
      env->CallStaticObjectMethod(type, of, static_cast<jint>(failure.status), message);
  if (!env->ExceptionCheck() && exception != nullptr)
    env->Throw(static_cast<jthrowable>(exception));
}

/** A text as UTF-8 bytes that end with 0; null is no text. */
class Text {
 public:
  Text() = default;
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;
  ~Text() {
    if (bytes_ != nullptr) env_->ReleaseByteArrayElements(array_, bytes_, JNI_ABORT);
  }
  const char* take(JNIEnv* env, jbyteArray array) {
    if (array == nullptr) return nullptr;
    env_ = env;
    array_ = array;
    bytes_ = env->GetByteArrayElements(array, nullptr);
    return reinterpret_cast<const char*>(bytes_);
  }

 private:
  JNIEnv* env_ = nullptr;
  jbyteArray array_ = nullptr;
  jbyte* bytes_ = nullptr;
};

/**
 * An array during one call, as class Rows describes it: a direct buffer is seen where it is, the elements of a Java
 * array are copied by the virtual machine, so that no collection waits for a long call.
 */
class Elements {
 public:
  Elements() = default;
  Elements(const Elements&) = delete;
  Elements& operator=(const Elements&) = delete;
  ~Elements() {
    if (release_ != nullptr) release_(env_, object_, memory_);
  }

  bool take(JNIEnv* env, jobject rows, ArrayIn** to) {
    *to = nullptr;
    if (rows == nullptr) return true;
    env_ = env;
    jclass type = env->GetObjectClass(rows);
    object_ = env->GetObjectField(rows, env->GetFieldID(type, "memory", "Ljava/lang/Object;"));
    array_.type = env->GetIntField(rows, env->GetFieldID(type, "type", "I"));
    array_.count =
        static_cast<std::uint64_t>(env->GetLongField(rows, env->GetFieldID(type, "count", "J")));
    array_.components = static_cast<std::uint32_t>(
        env->GetIntField(rows, env->GetFieldID(type, "components", "I")));
    array_.stride_bytes = static_cast<std::uint64_t>(
        env->GetLongField(rows, env->GetFieldID(type, "strideBytes", "J")));
    array_.flat = env->GetBooleanField(rows, env->GetFieldID(type, "flat", "Z")) == JNI_TRUE;
    array_.data = env->GetDirectBufferAddress(object_);
    if (array_.data == nullptr && array_.count != 0) {
      if (!copy_elements()) {
        raise_failure(env, Failure{JALON_ERROR_OUT_OF_MEMORY, "out of memory"});
        return false;
      }
      array_.data = memory_;
    }
    *to = &array_;
    return true;
  }
  bool take(JNIEnv* env, jobject object, const ArrayIn** to) {
    return take(env, object, const_cast<ArrayIn**>(to));
  }

 private:
  bool copy_elements() {
    switch (array_.type) {
      case JALON_FLOAT64:
        return copy<jdoubleArray>(&JNIEnv::GetDoubleArrayElements,
                                  &JNIEnv::ReleaseDoubleArrayElements);
      case JALON_FLOAT32:
        return copy<jfloatArray>(&JNIEnv::GetFloatArrayElements,
                                 &JNIEnv::ReleaseFloatArrayElements);
      case JALON_INT64:
        return copy<jlongArray>(&JNIEnv::GetLongArrayElements, &JNIEnv::ReleaseLongArrayElements);
      case JALON_INT32:
        return copy<jintArray>(&JNIEnv::GetIntArrayElements, &JNIEnv::ReleaseIntArrayElements);
      case JALON_INT16:
        return copy<jshortArray>(&JNIEnv::GetShortArrayElements,
                                 &JNIEnv::ReleaseShortArrayElements);
      default:
        return copy<jbyteArray>(&JNIEnv::GetByteArrayElements, &JNIEnv::ReleaseByteArrayElements);
    }
  }
  template <class JArray, class Element>
  bool copy(Element* (JNIEnv::*get)(JArray, jboolean*),
            void (JNIEnv::*release)(JArray, Element*, jint)) {
    memory_ = (env_->*get)(static_cast<JArray>(object_), nullptr);
    static void (JNIEnv::*releaser)(JArray, Element*, jint) = release;
    release_ = [](JNIEnv* env, jobject object, void* memory) {
      if (memory != nullptr)
        (env->*releaser)(static_cast<JArray>(object), static_cast<Element*>(memory), JNI_ABORT);
    };
    return memory_ != nullptr;
  }

  JNIEnv* env_ = nullptr;
  jobject object_ = nullptr;
  void* memory_ = nullptr;
  void (*release_)(JNIEnv*, jobject, void*) = nullptr;
  ArrayIn array_;
};

/** A Java array of the numbers, which are taken over. */
inline jdoubleArray doubles_of(JNIEnv* env, Array* numbers) {
  const std::unique_ptr<Array> taken(numbers);
  const jsize size = static_cast<jsize>(taken->count() * taken->components());
  jdoubleArray array = env->NewDoubleArray(size);
  if (array != nullptr)
    env->SetDoubleArrayRegion(array, 0, size, static_cast<const jdouble*>(taken->data()));
  return array;
}

inline jbyteArray octets_of(JNIEnv* env, Array* octets) {
  const std::unique_ptr<Array> taken(octets);
  if (taken->count() > 0x7ffffff7) {  // what virtual machines leave for their headers is not in it
    raise_failure(env,
                  Failure{JALON_ERROR_LIMIT, "more bytes than a Java array holds: write a file"});
    return nullptr;
  }
  const jsize size = static_cast<jsize>(taken->count());
  jbyteArray array = env->NewByteArray(size);
  if (array != nullptr)
    env->SetByteArrayRegion(array, 0, size, static_cast<const jbyte*>(taken->data()));
  return array;
}

/** The memory of so many items; it must not outlive the array. */
inline jobject buffer_of(JNIEnv* env, const Array& array, std::uint64_t first,
                         std::uint64_t items) {
  static char nothing[1];
  const std::uint64_t stride = array.stride_bytes();
  if (stride != 0 && items > 0x7fffffff / stride) {
    throw Failure{
        JALON_ERROR_LIMIT,
        std::to_string(items) + " items of " + std::to_string(stride) +
            " bytes: a Java buffer shows 2^31 - 1 bytes; take pieces with bytes(first, items)"};
  }
  char* data = static_cast<char*>(const_cast<void*>(array.data()));
  return env->NewDirectByteBuffer(data == nullptr ? nothing : data + first * stride,
                                  static_cast<jlong>(items * stride));
}

}  // namespace jalon_java

#endif
