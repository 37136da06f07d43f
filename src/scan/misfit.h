// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"
#include "scan/static_settings.h"

namespace jalon {

/// Error of a station's registration: a small turn about its centre and a shift, the same for all of its points.
class Misfit {
 public:
  Misfit(const StaticSettings& settings, size_t station);
  bool is_none() const { return is_none_; }
  /// What the field book says of a station that stands at this pose.
  Transform recorded(const Transform& pose) const;
  /// The same of a point that is seen at this vector from the station's true centre.
  Vec3 recorded(const Vec3& from, const Vec3& to_point) const {
    return is_none_ ? from + to_point : from + rotation_.direction(to_point) + shift_;
  }

 private:
  bool is_none_;
  Transform rotation_;
  Vec3 shift_;
};

}  // namespace jalon
