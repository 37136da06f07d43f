// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "formats/png/grey_file.h"
#include "formats/png/pictures.h"

namespace jalon {

namespace png {

bool has_libpng() { return false; }
void require_libpng(const std::string& path) {
  fail(Status::kUnsupported,
       "%.400s: PNG needs libpng, which this library was built without: install it "
       "(Debian: apt install libpng-dev) and build with -DJALON_WITH_LIBPNG=ON",
       path.c_str());
}

// Never called: require_libpng() comes before.
struct GreyReader::State {};
GreyReader::GreyReader(const ByteSource&, const char*) {}
GreyReader::~GreyReader() = default;
const std::vector<int32_t>& GreyReader::next_row() { return row_; }
void GreyReader::finish() {}
std::string grey_png(const GreyImage&, const char*, const std::string&, Task&) { return {}; }

}  // namespace png

std::string png_of(const IndexedImage&) {
  png::require_libpng("the picture");
  return {};
}
std::string png_of(const RgbaImage&, Task&) {
  png::require_libpng("the picture");
  return {};
}

}  // namespace jalon
