// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "model/model.h"

namespace jalon {

using Corners = std::vector<Vec3>;

/// A model under construction whose faces share their equal corners. Places are relative to an origin.
class SharedFaces {
 public:
  explicit SharedFaces(const Vec3& origin) : origin_(origin) {}

  uint32_t part(std::string name, std::string part_class, uint64_t parent,
                Evidence evidence = Evidence::kMeasured);
  Part& at(uint32_t part) { return model_.parts[part]; }
  size_t size() const { return model_.faces.size(); }

  struct Hole {
    Corners corners;  ///< clockwise
    uint32_t part;    ///< the opening that fills it
  };
  /// Outline anticlockwise, seen from where it is looked at. Faces without area are left out.
  void add(uint32_t part, uint32_t id, const Corners& outline, const std::vector<Hole>& holes = {});
  /// The faces from this one on enclose a volume.
  void close(uint32_t part, size_t first_face);

  Model take(SharedText crs);

 private:
  void add_ring(const Corners& corners, uint32_t part);

  Vec3 origin_;
  Model model_;
  std::map<std::array<double, 3>, uint32_t> vertices_;
};

}  // namespace jalon
