// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// How a scanner spreads its points over the directions.
enum class Spreading : uint8_t {
  kEvenAngles,      ///< even steps of both angles about the z axis: dense above and below
  kEvenDirections,  ///< alike in all directions
};

/// How dense a scanner's points lie at a place of a surface: as neighbours spread over so much.
struct DensityPlace {
  Vec3 place, normal;  ///< normal of either sign
  double spacing_m = 0;
};

struct StationFit {
  Vec3 place;
  double spread =
      0;  ///< mean deviation of the logarithm of the density from the law; infinity: no fit
};

/// Where a cloud was taken from, by how dense its points lie: a scanner leaves cos(incidence) / range^2 points an
/// area, over the cosine of the height angle with even angles. The place at which the logarithm of density times its
/// inverse varies least, by a search over their box and about it, and from the best places
/// downhill. O(places).
StationFit fit_station(std::span<const DensityPlace> places, Spreading spreading, Task& task);

}  // namespace jalon
