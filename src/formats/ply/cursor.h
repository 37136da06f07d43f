// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#include "formats/files/endian.h"
#include "formats/files/fast_number.h"
#include "formats/ply/header.h"

namespace jalon::ply {

/// Reads the values behind a PLY header one after the other, in any of the three encodings. Never
/// beyond the end of the file.
class Cursor {
 public:
  Cursor(const ByteSource& source, Encoding encoding, uint64_t offset)
      : source_(source),
        encoding_(encoding),
        offset_(offset),
        buffer_(std::make_unique_for_overwrite<char[]>(kBufferBytes)) {}

  /// Where the next value lies.
  uint64_t offset() const { return offset_ + at_; }
  uint64_t remaining() const { return source_.size() - offset(); }

  /// The next value, stored as `type` in the file, as a T; refused where T cannot hold it.
  template <class T>
  T value(ElementType type) {
    return visit(type, [&](auto zero) {
      using Stored = decltype(zero);
      if (encoding_ == Encoding::kAscii) return token<T, Stored>();
      const char* bytes = need(sizeof(Stored));
      const Stored stored = encoding_ == Encoding::kLittle ? load<Stored>(bytes)
                                                           : load<Stored, std::endian::big>(bytes);
      at_ += sizeof(Stored);
      return converted<T>(stored);
    });
  }

  /// The length of a list that the file has room for.
  uint64_t list_length(const Property& property) {
    const uint64_t from = offset();
    const auto length = value<int64_t>(property.count_type);
    const uint64_t item = encoding_ == Encoding::kAscii ? 2 : size_of(property.type);
    if (length < 0 || static_cast<uint64_t>(length) > (remaining() + 1) / item)
      source_.refuse(from, "a list of %lld items does not fit the file",
                     static_cast<long long>(length));
    return static_cast<uint64_t>(length);
  }

  void skip(const Property& property) {
    uint64_t values = property.list ? list_length(property) : 1;
    if (encoding_ == Encoding::kAscii) {
      while (values-- > 0) (void)value<double>(ElementType::kFloat64);
    } else {
      skip_bytes(values * size_of(property.type));
    }
  }

  void skip_bytes(uint64_t bytes) {
    if (bytes > remaining()) source_.refuse(offset(), "the file ends too early");
    if (bytes <= filled_ - at_) {
      at_ += static_cast<size_t>(bytes);
    } else {
      offset_ += at_ + bytes;
      at_ = filled_ = 0;
    }
  }

 private:
  static constexpr size_t kBufferBytes = size_t{64} << 10;
  static constexpr size_t kTokenBytes = 512;  // the longest number is far shorter

  // At least `bytes` in the buffer, or refused.
  const char* need(size_t bytes) {
    if (filled_ - at_ < bytes) refill();
    if (filled_ - at_ < bytes) source_.refuse(offset(), "the file ends too early");
    return buffer_.get() + at_;
  }
  void refill() {
    std::memmove(buffer_.get(), buffer_.get() + at_, filled_ - at_);
    offset_ += at_;
    filled_ -= at_;
    at_ = 0;
    filled_ +=
        source_.read_some(offset_ + filled_, buffer_.get() + filled_, kBufferBytes - filled_);
  }

  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  template <class T, class Stored>
  T token() {
    for (;;) {
      while (at_ < filled_ && is_blank(buffer_[at_])) ++at_;
      if (at_ < filled_) break;
      refill();
      if (filled_ == 0) source_.refuse(offset(), "the file ends too early");
    }
    if (filled_ - at_ < kTokenBytes) refill();
    const char* begin = buffer_.get() + at_;
    const char* end = buffer_.get() + filled_;
    Stored stored{};
    const char* stop = nullptr;
    if constexpr (std::is_floating_point_v<Stored>) {
      ParsedNumber number;
      stop = parse_number_at(begin, end, number);
      stored = static_cast<Stored>(number.value);
      if constexpr (std::is_same_v<Stored, float>)  // rounded once
        if (stop != nullptr && *begin != '+') std::from_chars(begin, stop, stored);
    } else {
      const auto [p, error] = std::from_chars(begin + (*begin == '+' ? 1 : 0), end, stored);
      stop = error == std::errc() ? p : nullptr;
      // Some writers give whole numbers a point.
      if (stop != nullptr && stop != end && !is_blank(*stop)) {
        ParsedNumber number;
        stop = parse_number_at(begin, end, number);
        if (stop != nullptr && number.value != static_cast<double>(stored)) stop = nullptr;
      }
    }
    if (stop == nullptr || (stop != end && !is_blank(*stop)))
      source_.refuse(offset(), "there is no number of the property's type here");
    at_ += static_cast<size_t>(stop - begin);
    return converted<T>(stored);
  }

  template <class T, class Stored>
  T converted(Stored stored) const {
    if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(stored);
    } else if constexpr (std::is_floating_point_v<Stored>) {
      const double rounded = std::nearbyint(static_cast<double>(stored));
      if (rounded != stored || rounded < static_cast<double>(std::numeric_limits<T>::lowest()) ||
          rounded >= std::ldexp(1.0, std::numeric_limits<T>::digits))
        source_.refuse(offset(), "a whole number was expected");
      return static_cast<T>(rounded);
    } else {
      if (!std::in_range<T>(stored)) source_.refuse(offset(), "a number is out of range");
      return static_cast<T>(stored);
    }
  }

  const ByteSource& source_;
  Encoding encoding_;
  uint64_t offset_;
  std::unique_ptr<char[]> buffer_;
  size_t at_ = 0, filled_ = 0;
};

}  // namespace jalon::ply
