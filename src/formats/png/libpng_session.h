// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "formats/files/byte_source.h"

// How libpng is called, for the files libpng_*.cpp alone.
namespace jalon::png {

// What libpng calls back with, and what it said when it gave up. It leaves its functions by longjmp, which must pass
// over no object with a destructor: guarded() is the only place that it comes back to, and the steps that it is given
// have none.
struct Session {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::exception_ptr failure;  ///< of a callback
  char message[160] = {};

  const ByteSource* source = nullptr;  // of a reader
  uint64_t offset = 0;
  png_bytep row = nullptr;

  std::string* out = nullptr;  // of a writer
  const void* picture = nullptr;
};

[[noreturn]] inline void give_up(png_structp png, png_const_charp message) {
  auto* session = static_cast<Session*>(png_get_error_ptr(png));
  std::strncpy(session->message, message, sizeof session->message - 1);
  png_longjmp(png, 1);
}
inline void keep_quiet(png_structp, png_const_charp) {}

inline bool guarded(Session& session, void (*step)(Session&)) {
  if (setjmp(png_jmpbuf(session.png)) != 0) return false;
  step(session);
  return true;
}

// Throws what a callback met, or that there was no memory; else it was the file.
inline void throw_own(const Session& session) {
  if (session.failure) std::rethrow_exception(session.failure);
  if (std::string_view(session.message).find("memory") != std::string_view::npos)
    throw std::bad_alloc();
}

template <class F>
void call_back(png_structp png, Session& session, F&& f) {
  try {
    f();
  } catch (...) {
    session.failure = std::current_exception();
  }
  if (session.failure) png_error(png, "the host failed");
}

}  // namespace jalon::png
