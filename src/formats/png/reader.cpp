// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstring>

#include "formats/files/finish_cloud.h"
#include "formats/files/growing_cloud.h"
#include "formats/png/grey_file.h"
#include "formats/png/grid.h"
#include "formats/png/png.h"

namespace jalon {

// ISO/IEC 15948, 5.2: the signature.
bool is_png(const ByteSource& source) {
  constexpr char kSignature[] = "\x89PNG\r\n\x1a\n";
  std::array<char, 8> first{};
  return source.read_some(0, first.data(), first.size()) == first.size() &&
         std::memcmp(first.data(), kSignature, first.size()) == 0;
}

Cloud read_png(const ByteSource& source, const ReadSettings& settings, Task& task) {
  png::require_libpng(source.path());
  GrowingCloud cloud;
  {
    ProgressSpan span(task, 0, 0.95, "reading PNG");
    png::GreyReader reader(source, png::kGridKeyword);
    const png::DepthGrid grid = png::grid_of_file(source, reader.text(), reader.height(), settings);
    const std::array<size_t, 2> fields{
        cloud.field({"row", ElementType::kUint32, 1, "", "line of the image, from the top"}),
        cloud.field({"column", ElementType::kUint32, 1, "", "column of the image"})};
    for (uint32_t r = 0; r < reader.height(); ++r) {
      task.checkpoint(static_cast<double>(r) / reader.height());
      const std::vector<int32_t>& row = reader.next_row();
      for (uint32_t c = 0; c < reader.width(); ++c) {
        if (row[c] < 0) continue;
        const std::array<double, 2> values{static_cast<double>(r), static_cast<double>(c)};
        cloud.add(grid.point(c, r, static_cast<uint32_t>(row[c])), fields, values);
      }
    }
    reader.finish();
  }
  return finish_cloud(cloud.finish(task), source, settings.drop_invalid, task);
}

}  // namespace jalon
