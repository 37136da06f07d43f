/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The listeners of a Java task. Jalon calls back on the thread that made the call, which is a Java thread. */
#ifndef JALON_BINDINGS_JAVA_TASK_H
#define JALON_BINDINGS_JAVA_TASK_H

#include "java_support.h"

namespace jalon_java {

/** Weak references: the Java task holds its listeners, and is held by the call that runs. */
class Listeners {
 public:
  explicit Listeners(JNIEnv* env) { env->GetJavaVM(&machine_); }
  ~Listeners() {
    if (JNIEnv* env = this->env()) forget(env);
  }
  void set(JNIEnv* env, jobject progress, jobject log) {
    const std::lock_guard<std::mutex> lock(mutex_);
    forget(env);
    if (progress != nullptr) progress_ = env->NewWeakGlobalRef(progress);
    if (log != nullptr) log_ = env->NewWeakGlobalRef(log);
  }
  jobject progress(JNIEnv* env) const { return local(env, progress_); }
  jobject log(JNIEnv* env) const { return local(env, log_); }
  /** Of this thread; nullptr on one that Java does not know. */
  JNIEnv* env() const {
    void* env = nullptr;
    return machine_->GetEnv(&env, JNI_VERSION_1_8) == JNI_OK ? static_cast<JNIEnv*>(env) : nullptr;
  }

 private:
  jobject local(JNIEnv* env, const jweak& reference) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reference == nullptr ? nullptr : env->NewLocalRef(reference);
  }
  void forget(JNIEnv* env) {
    if (progress_ != nullptr) env->DeleteWeakGlobalRef(progress_);
    if (log_ != nullptr) env->DeleteWeakGlobalRef(log_);
    progress_ = log_ = nullptr;
  }

  JavaVM* machine_ = nullptr;
  mutable std::mutex mutex_;
  jweak progress_ = nullptr, log_ = nullptr;
};

/** Runs one callback in a frame of its own; false: Java threw, now or before. */
template <class Call>
bool in_java(const Listeners& listeners, Call call) {
  JNIEnv* env = listeners.env();
  if (env == nullptr) return true;
  if (env->ExceptionCheck()) return false;
  if (env->PushLocalFrame(8) != 0) return false;
  call(env);
  const bool fine = !env->ExceptionCheck();
  env->PopLocalFrame(nullptr);
  if (fine) return true;
  jalon_binding::host_failed() = true;
  return false;
}

inline std::int32_t on_progress(double fraction, const char* stage, void* user) {
  const Listeners& listeners = *static_cast<Listeners*>(user);
  bool go_on = true;
  const bool fine = in_java(listeners, [&](JNIEnv* env) {
    jobject listener = listeners.progress(env);
    jbyteArray text = listener == nullptr ? nullptr : bytes_of(env, stage == nullptr ? "" : stage);
    jclass calls = text == nullptr ? nullptr : env->FindClass("org/jalon/Text");
    if (calls == nullptr) return;
    jmethodID method =
        env->GetStaticMethodID(calls, "progress", "(Lorg/jalon/ProgressListener;D[B)Z");
    if (method != nullptr)
      go_on = env->CallStaticBooleanMethod(calls, method, listener, fraction, text) != JNI_FALSE;
  });
  return fine && go_on ? 0 : 1;
}

inline void on_log(std::int32_t level, const char* line, void* user) {
  const Listeners& listeners = *static_cast<Listeners*>(user);
  in_java(listeners, [&](JNIEnv* env) {
    jobject listener = listeners.log(env);
    jbyteArray text = listener == nullptr ? nullptr : bytes_of(env, line == nullptr ? "" : line);
    jclass calls = text == nullptr ? nullptr : env->FindClass("org/jalon/Text");
    if (calls == nullptr) return;
    jmethodID method = env->GetStaticMethodID(calls, "log", "(Lorg/jalon/LogListener;I[B)V");
    if (method != nullptr)
      env->CallStaticVoidMethod(calls, method, listener, static_cast<jint>(level), text);
  });
}

/** The listeners of the next calls with this task; they live in its box. */
inline void listen(JNIEnv* env, jalon_binding::Task& task, jobject progress, jobject log) {
  const jalon_binding::Use<jalon_task> use(&task);
  if (task.host == nullptr) task.host = std::make_shared<Listeners>(env);
  Listeners& listeners = *static_cast<Listeners*>(task.host.get());
  listeners.set(env, progress, log);
  jalon_binding::check(
      jalon_task_set_progress(use, progress == nullptr ? nullptr : on_progress, &listeners));
  jalon_binding::check(jalon_task_set_log(use, log == nullptr ? nullptr : on_log, &listeners));
}

}  // namespace jalon_java

#endif
