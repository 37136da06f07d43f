/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What all three languages share: C handles in boxes that may be closed at any time, and statuses as C++ exceptions
 * that the language layer turns into its own. */
#ifndef JALON_BINDINGS_HANDLES_H
#define JALON_BINDINGS_HANDLES_H

#include <jalon/jalon.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <utility>

namespace jalon_binding {

/** Beside the statuses of jalon/status.h: the object was closed. */
constexpr std::int32_t kClosed = -1000;

/** A failed call, on its way to the language. */
struct Failure {
  std::int32_t status;
  std::string message;
};

/** A callback of the host failed during the call that this thread makes; the language layer keeps what it was. */
inline bool& host_failed() {
  thread_local bool failed = false;
  return failed;
}

/** What the language calls C's NULL. */
#ifdef SWIGPYTHON
constexpr char kNoObject[] = "None";
#else
constexpr char kNoObject[] = "null";
#endif

/** The library's message; where it ends with NULL, in the words of the language: "xyz is None". */
inline std::string last_message() {
  static const std::string ending = " NULL";
  std::string message = jalon_last_error_message();
  const std::size_t kept = message.size() < ending.size() ? 0 : message.size() - ending.size();
  if (message.compare(kept, std::string::npos, ending) == 0)
    message.replace(kept, std::string::npos, std::string(" ") + kNoObject);
  return message;
}

inline void check(jalon_status status) {
  if (status != JALON_OK) throw Failure{status, last_message()};
  if (host_failed()) throw Failure{JALON_ERROR_CANCELLED, "cancelled by the host"};
}

/** What is being thrown, as a status and a message: for the catch block of every wrapper. */
inline Failure current_failure() {
  try {
    throw;
  } catch (const Failure& failure) {
    return failure;
  } catch (const std::bad_alloc&) {
    return Failure{JALON_ERROR_OUT_OF_MEMORY, "out of memory"};
  } catch (const std::exception& error) {
    return Failure{JALON_ERROR_INTERNAL, error.what()};
  } catch (...) {
    return Failure{JALON_ERROR_INTERNAL, "an unknown exception"};
  }
}

/** Handles that boxes, results and arrays hold in this process; tests watch it. */
inline std::atomic<std::int64_t>& live_handles() {
  static std::atomic<std::int64_t> count{0};
  return count;
}

/** What each C handle is called with. */
template <class H>
struct Ownership;

#define JALON_OWNERSHIP(noun, name)                                     \
  template <>                                                           \
  struct Ownership<noun> {                                              \
    static const char* text() { return name; }                          \
    static noun* retain(noun* handle) { return noun##_retain(handle); } \
    static void release(noun* handle) { noun##_release(handle); }       \
  };

/** One owner of a C handle; the slot that a call writes its output to. */
template <class H>
class Owned {
 public:
  Owned() = default;
  explicit Owned(H* handle) : handle_(handle) { count(); }
  Owned(Owned&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)), counted_(other.counted_) {}
  Owned& operator=(Owned&&) = delete;
  ~Owned() {
    if (handle_ == nullptr) return;
    Ownership<H>::release(handle_);
    if (counted_) --live_handles();
  }
  H** slot() { return &handle_; }
  H* get() const { return handle_; }
  H* retained() const { return handle_ == nullptr ? nullptr : Ownership<H>::retain(handle_); }
  /** After slot() was written to. */
  void count() {
    if (handle_ != nullptr && !counted_) ++live_handles();
    counted_ = true;
  }
  H* give() {
    if (handle_ != nullptr && counted_) --live_handles();
    return std::exchange(handle_, nullptr);
  }

 private:
  H* handle_ = nullptr;
  bool counted_ = false;
};

/**
 * The box that an object of the language holds. It lives as long as that object, so that a call after close() finds it
 * and says so; close() during a call is refused. Any thread.
 */
template <class H>
class Handle {
 public:
  explicit Handle(H* owned) : handle_(owned) { ++live_handles(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { drop(); }

  /** Gives the native memory back now. Closing twice is harmless. */
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (uses_ != 0)
      throw Failure{JALON_ERROR_BUSY,
                    std::string(Ownership<H>::text()) + " is in use by a running call"};
    drop();
  }
  bool closed() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return handle_ == nullptr;
  }

  H* begin_use() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (handle_ == nullptr)
      throw Failure{kClosed, std::string(Ownership<H>::text()) + " is closed"};
    ++uses_;
    return handle_;
  }
  void end_use() {
    const std::lock_guard<std::mutex> lock(mutex_);
    --uses_;
  }

  /** What the language keeps with it as long as the box lives, e.g. callbacks. */
  std::shared_ptr<void> host;

 private:
  void drop() {
    if (handle_ == nullptr) return;
    Ownership<H>::release(handle_);
    handle_ = nullptr;
    --live_handles();
  }

  mutable std::mutex mutex_;
  H* handle_;
  int uses_ = 0;
};

/** The handle of a box during one call; of no box NULL, which the library refuses where it must. */
template <class H>
class Use {
 public:
  explicit Use(Handle<H>* box) : box_(box), handle_(box == nullptr ? nullptr : box->begin_use()) {}
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() {
    if (box_ != nullptr) box_->end_use();
  }
  operator H*() const { return handle_; }  // NOLINT: stands for the handle

 private:
  Handle<H>* box_;
  H* handle_;
};

/** A box around what a call gave; nullptr stays nullptr. */
template <class H>
Handle<H>* boxed(Owned<H>& owned) {
  if (owned.get() == nullptr) return nullptr;
  std::unique_ptr<Handle<H>> box(new Handle<H>(owned.get()));
  owned.give();
  return box.release();
}

/** One more owner, in a box of its own: what a result object hands out. */
template <class H>
Handle<H>* boxed_copy(const Owned<H>& owned) {
  Owned<H> copy(owned.retained());
  return boxed(copy);
}

/** One more box of the same handle: a copy, where objects never change. */
template <class H>
Handle<H>* again(Handle<H>* box) {
  const Use<H> use(box);
  Owned<H> copy(Ownership<H>::retain(use));
  return boxed(copy);
}

}  // namespace jalon_binding

#endif
