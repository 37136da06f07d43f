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
  if (bytes != nullptr) env->SetByteArrayRegion(bytes, 0, size, reinterpret_cast<const jbyte*>(text.data()));
  return bytes;
}

/** JalonException.of(status, message), thrown. */
inline void raise_failure(JNIEnv* env, const Failure& failure) {
  if (env->ExceptionCheck()) return;
  jclass type = env->FindClass("org/jalon/JalonException");
  if (type == nullptr) return;
  jmethodID of = env->GetStaticMethodID(type, "of", "(I[B)Lorg/jalon/JalonException;");
  jbyteArray message = of == nullptr ? nullptr : bytes_of(env, failure.message);
  if (message == nullptr) return;
  jobject exception = env->CallStaticObjectMethod(type, of, static_cast<jint>(failure.status), message);
  if (exception != nullptr) env->Throw(static_cast<jthrowable>(exception));
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

/** A primitive array (its elements are copied by the virtual machine) during one call. */
class Elements {
 public:
  Elements() = default;
  Elements(const Elements&) = delete;
  Elements& operator=(const Elements&) = delete;
  ~Elements() {
    if (release_ != nullptr) release_(env_, object_, memory_);
  }

  bool take(JNIEnv* env, jobject object, ArrayIn** to) {
    *to = nullptr;
    if (object == nullptr) return true;
    env_ = env;
    object_ = object;
    const bool found =
        try_array<jdoubleArray, jdouble>("[D", JALON_FLOAT64, &JNIEnv::GetDoubleArrayElements,
                                         &JNIEnv::ReleaseDoubleArrayElements) ||
        try_array<jfloatArray, jfloat>("[F", JALON_FLOAT32, &JNIEnv::GetFloatArrayElements,
                                       &JNIEnv::ReleaseFloatArrayElements) ||
        try_array<jlongArray, jlong>("[J", JALON_INT64, &JNIEnv::GetLongArrayElements,
                                     &JNIEnv::ReleaseLongArrayElements) ||
        try_array<jintArray, jint>("[I", JALON_INT32, &JNIEnv::GetIntArrayElements, &JNIEnv::ReleaseIntArrayElements) ||
        try_array<jshortArray, jshort>("[S", JALON_INT16, &JNIEnv::GetShortArrayElements,
                                       &JNIEnv::ReleaseShortArrayElements) ||
        try_array<jbyteArray, jbyte>("[B", JALON_UINT8, &JNIEnv::GetByteArrayElements,
                                     &JNIEnv::ReleaseByteArrayElements);
    if (!found) {
      raise_failure(env, Failure{JALON_ERROR_INVALID_ARGUMENT, "an array of numbers is needed"});
      return false;
    }
    if (memory_ == nullptr) {
      raise_failure(env, Failure{JALON_ERROR_OUT_OF_MEMORY, "out of memory"});
      return false;
    }
    *to = &array_;
    return true;
  }
  bool take(JNIEnv* env, jobject object, const ArrayIn** to) { return take(env, object, const_cast<ArrayIn**>(to)); }

 private:
  template <class JArray, class Element>
  bool try_array(const char* type, std::int32_t element_type, Element* (JNIEnv::*get)(JArray, jboolean*),
                 void (JNIEnv::*release)(JArray, Element*, jint)) {
    jclass wanted = env_->FindClass(type);
    if (wanted == nullptr || !env_->IsInstanceOf(object_, wanted)) return false;
    memory_ = (env_->*get)(static_cast<JArray>(object_), nullptr);
    static void (JNIEnv::*releaser)(JArray, Element*, jint) = release;
    release_ = [](JNIEnv* env, jobject object, void* memory) {
      if (memory != nullptr) (env->*releaser)(static_cast<JArray>(object), static_cast<Element*>(memory), JNI_ABORT);
    };
    array_ =
        ArrayIn(memory_, element_type, static_cast<std::uint64_t>(env_->GetArrayLength(static_cast<jarray>(object_))));
    return true;
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
  if (array != nullptr) env->SetDoubleArrayRegion(array, 0, size, static_cast<const jdouble*>(taken->data()));
  return array;
}

/** The memory of an array, in native byte order only after ByteBuffer.order(); it must not outlive the array. */
inline jobject buffer_of(JNIEnv* env, const Array& array) {
  static char nothing[1];
  const std::uint64_t bytes = array.count() * array.stride_bytes();
  if (bytes > 0x7fffffff)
    throw Failure{JALON_ERROR_LIMIT, "more than 2^31 - 1 bytes: a Java buffer cannot show them at once"};
  return env->NewDirectByteBuffer(array.data() == nullptr ? nothing : const_cast<void*>(array.data()),
                                  static_cast<jlong>(bytes));
}

}  // namespace jalon_java

#endif
