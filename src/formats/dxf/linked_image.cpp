// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/linked_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/facade_views.h"
#include "formats/files/byte_source.h"
#include "formats/files/endian.h"

namespace jalon::dxf {

namespace {

constexpr size_t kMostWorldBytes = 1024;  // six numbers, a line each
constexpr double kSquare = 1e-6;  // of a pixel's side: far below a pixel over a whole picture

/// Of a world file, as far as it is upright with square pixels: the middle of the first pixel.
struct World {
  double pixel_m = 0, x_m = 0, y_m = 0;
};

World read_world(const std::string& path) {
  const ByteSource source(path);
  std::string text(kMostWorldBytes, '\0');
  text.resize(source.read_some(0, text.data(), text.size()));
  std::array<double, 6> values{};
  std::string_view rest = text;
  for (double& value : values) {
    const size_t first = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
    rest.remove_prefix(first);
    const size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    if (!parse_number(rest.substr(0, end), value) || !std::isfinite(value))
      source.refuse(text.size() - rest.size(), "a world file has six numbers");
    rest.remove_prefix(end);
  }
  const bool is_square = std::fabs(values[3] + values[0]) <= kSquare * values[0];
  if (!(values[0] > 0) || values[1] != 0 || values[2] != 0 || !is_square)
    source.refuse(0, "the world file turns or stretches its picture");
  return {values[0], values[4], values[5]};
}

// ISO/IEC 15948: the signature, the length and name of the first chunk, width and height.
std::array<uint32_t, 2> read_size(const std::string& path) {
  const ByteSource source(path);
  char header[24] = {};
  const size_t bytes = source.read_some(0, header, sizeof header);
  if (bytes < sizeof header || !std::string_view(header, 8).starts_with("\x89PNG\r\n\x1a\n"))
    source.refuse(0, "an image of a drawing is a PNG file, this is none");
  return {load<uint32_t, std::endian::big>(header + 16),
          load<uint32_t, std::endian::big>(header + 20)};
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find_last_of("/\\") + 1);  // of Windows too
}

LinkedImage linked(const std::string& path, const std::string& drawing,
                   const std::vector<PlacedFacade>& facades, bool in_space) {
  const auto [columns, rows] = read_size(path);
  const World world = read_world(path.substr(0, path.find_last_of('.') + 1) + "pgw");
  const double left_m = world.x_m - world.pixel_m / 2;
  const double bottom_m = world.y_m + world.pixel_m / 2 - rows * world.pixel_m;
  const double middle_m = left_m + columns * world.pixel_m / 2;
  LinkedImage out{.link = path, .columns = columns, .rows = rows};
  // A drawing that moves takes along what lies beside it.
  if (folder_of(path) == folder_of(drawing)) out.link = path.substr(folder_of(path).size());
  out.at = {left_m, bottom_m, 0};
  out.right = {world.pixel_m, 0, 0};
  out.up = {0, world.pixel_m, 0};
  for (const PlacedFacade& facade : facades) {
    if (middle_m < facade.left_m || middle_m > facade.right_m) continue;
    if (in_space) {
      out.at = facade.in_space(out.at);
      out.right = facade.view.right * world.pixel_m;
      out.up = {0, 0, world.pixel_m};
    }
    return out;
  }
  fail(Status::kInvalidArgument, "%.400s: no facade of the model lies where its world file puts it",
       path.c_str());
}

}  // namespace

std::vector<LinkedImage> linked_images(const std::string& list, const std::string& drawing,
                                       const Model& model, bool in_space) {
  std::vector<LinkedImage> out;
  const std::vector<PlacedFacade> facades = facades_side_by_side(model);
  for (size_t at = 0; at < list.size();) {
    const size_t end = std::min(list.find('|', at), list.size());
    if (end > at) out.push_back(linked(list.substr(at, end - at), drawing, facades, in_space));
    at = end + 1;
  }
  return out;
}

}  // namespace jalon::dxf
