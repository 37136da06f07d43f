// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/png/grid.h"

#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon::png {

namespace {

constexpr size_t kMostWorldFileBytes = 1024;  // six numbers, a line each

// As many numbers as there is room for and nothing else; false when the text is not that.
template <size_t N>
bool parse_numbers(std::string_view text, std::array<double, N>& out) {
  constexpr std::string_view kBlank = " \t\r\n";
  for (double& value : out) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    const size_t end = std::min(text.find_first_of(kBlank), text.size());
    if (!parse_number(text.substr(0, end), value) || !std::isfinite(value)) return false;
    text.remove_prefix(end);
  }
  return text.find_first_not_of(kBlank) == std::string_view::npos;
}

std::string world_path(const std::string& path) {
  const size_t dot = path.rfind('.'), slash = path.find_last_of("/\\");
  const bool has_extension =
      dot != std::string::npos && (slash == std::string::npos || dot > slash);
  return (has_extension ? path.substr(0, dot) : path) + ".pgw";
}

// The six numbers of a world file (ESRI): x and y of a step to the right, of one down, of the first pixel's middle.
std::optional<std::array<double, 6>> world_beside(const std::string& path) {
  std::optional<ByteSource> world;
  try {
    world.emplace(world_path(path));
  } catch (const Error& error) {
    if (error.status() != Status::kNotFound) throw;
    return std::nullopt;
  }
  std::string text(kMostWorldFileBytes, '\0');
  text.resize(world->read_some(0, text.data(), text.size()));
  std::array<double, 6> numbers{};
  if (!parse_numbers(text, numbers)) world->refuse(0, "a world file has six numbers");
  return numbers;
}

}  // namespace

std::string text_of_grid(const DepthGrid& grid) {
  std::string out;
  for (const Vec3& v : {grid.origin, grid.right, grid.down, grid.toward})
    for (int k = 0; k < 3; ++k) out += (out.empty() ? "" : " ") + text_of(v[k]);
  return out;
}

bool parse_grid(std::string_view text, DepthGrid& out) {
  std::array<double, 12> n{};
  if (!parse_numbers(text, n)) return false;
  out = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[9], n[10], n[11]}};
  return true;
}

DepthGrid grid_of_file(const ByteSource& source, const std::string& text, uint32_t rows,
                       const ReadSettings& settings) {
  DepthGrid grid;
  if (!text.empty()) {
    if (!parse_grid(text, grid))
      source.refuse(0, "the text \"%s\" has not the twelve numbers of a grid", kGridKeyword);
    return grid;
  }
  if (settings.png_step_m == 0)
    source.refuse(0,
                  "the file does not tell what a grey value is in metres: the option "
                  "\"png_step_m\" does");
  grid.toward = {0, 0, settings.png_step_m};
  if (const auto world = world_beside(source.path())) {
    const auto& n = *world;
    grid.right = {n[0], n[1], 0};
    grid.down = {n[2], n[3], 0};
    grid.origin = {n[4], n[5], settings.png_zero_m};
    return grid;
  }
  const double pixel = settings.png_source_pixel_m;
  if (!(pixel > 0))
    source.refuse(0,
                  "neither the file nor a world file (pgw) beside it tells what a pixel is in "
                  "metres: the option \"png_source_pixel_m\" does");
  grid.right = {pixel, 0, 0};
  grid.down = {0, -pixel, 0};
  grid.origin = {0.5 * pixel, (rows - 0.5) * pixel, settings.png_zero_m};
  return grid;
}

}  // namespace jalon::png
