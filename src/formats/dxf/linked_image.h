// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"
#include "model/model.h"

namespace jalon::dxf {

/// A picture that a drawing shows by its file.
struct LinkedImage {
  std::string link;  ///< its file, as the drawing names it
  uint32_t columns = 0, rows = 0;
  Vec3 at = {};              ///< its lower left corner
  Vec3 right = {}, up = {};  ///< along one pixel
};

/// The orthoimages of a list of PNG files, separated by '|', each with a world file (pgw) beside it in the coordinates
/// of the elevation; in those, or where their facades are in space. drawing: the path of the file that will name them.
/// Error(kFormat) for a file that is no PNG or no upright world file, kInvalidArgument where no facade lies below one.
std::vector<LinkedImage> linked_images(const std::string& list, const std::string& drawing,
                                       const Model& model, bool in_space);

}  // namespace jalon::dxf
