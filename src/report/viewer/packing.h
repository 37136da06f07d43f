// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/task.h"
#include "report/viewer/scene.h"

namespace jalon {

/// A cloud as the page has it.
struct PackedCloud {
  size_t points = 0;
  double step_m = 0.001;    ///< of the coordinates
  double spacing_m = 0.01;  ///< about the distance of neighbours
  Vec3 low, size;           ///< corner and size of the box, in the cloud's frame
  std::vector<double> channel_steps;
  std::vector<bool>
      channel_is_plain;  ///< told as it is, not as differences: of noise they are larger
  std::string bytes;     ///< zlib
};

/// At most this many points, evenly taken in the order of the octree's cells and then of the points: the same bytes
/// each time. Coordinates count steps of a millimetre (or of the longest side / 65535 where that is more) from the
/// low corner; numbers are told as differences from the point before, zigzag, all low bytes before all high ones, and
/// deflated; then the channels alike: labels, values in 256ths of their scale, colours as three bytes.
PackedCloud pack_cloud(const ViewCloud& view, size_t most_points, Task& task);

/// Bytes as text: five characters for four of them, which a page holds as they are ("<" is none of them). As many
/// zeros as are missing stand at the end.
std::string text_of_bytes(std::string_view bytes);

/// The codes of the first and second kind of points without a value, of which a page has colours.
constexpr int32_t kViewNone = -32768;

}  // namespace jalon
