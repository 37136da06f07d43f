// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/task.h"
#include "formats/drawings/depth_image.h"
#include "formats/files/byte_source.h"

// libpng is an optional component: libpng_file.cpp and libpng_writing.cpp are compiled, or libpng_absent.cpp.
namespace jalon::png {

/// Whether this library was built with libpng.
bool has_libpng();
/// Error(kUnsupported) where it was not, with the package that brings it.
void require_libpng(const std::string& path);

/// Most pixels of an image that is read.
inline constexpr uint64_t kMostPixels = kMostDepthPixels;

/// A grey picture, row by row: memory for one row, whatever the header says. What libpng refuses is Error(kFormat),
/// colours and interlaced files are Error(kUnsupported), too many pixels Error(kLimit).
class GreyReader {
 public:
  GreyReader(const ByteSource& source, const char* keyword);
  ~GreyReader();
  GreyReader(const GreyReader&) = delete;
  GreyReader& operator=(const GreyReader&) = delete;

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  /// Of the chunk tEXt, zTXt or iTXt with the keyword before the first row; "": there is none.
  const std::string& text() const { return text_; }
  /// Grey values of the next row; -1: no return.
  const std::vector<int32_t>& next_row();
  /// The end of the file, once all rows are read.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
  uint32_t width_ = 0, height_ = 0;
  std::string text_;
  std::vector<int32_t> row_;
};

struct GreyImage {
  uint32_t width = 0, height = 0;
  int bits = 16;                 ///< 16 or 8
  std::vector<uint16_t> pixels;  ///< row by row from the top; 0 is transparent
};

/// The picture as a PNG file with a text under the keyword.
std::string grey_png(const GreyImage& image, const char* keyword, const std::string& text,
                     Task& task);

}  // namespace jalon::png
