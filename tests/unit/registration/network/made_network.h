// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "base/random.h"
#include "registration/network/network_settings.h"
#include "registration/network/survey.h"

namespace jalon::test {

struct Nail {
  const char* id;
  Vec3 place;
};

/// The 12 stations of a published survey by feature codes (Lambert 2008, less 600 000 and 1 200 000; code 921).
inline const std::array<Nail, 12>& nails() {
  static const std::array<Nail, 12> all{{{"5", {27.909, 87.596, 246.636}},
                                         {"4", {20.679, 137.221, 246.481}},
                                         {"3", {85.630, 154.136, 247.174}},
                                         {"2", {130.486, 116.672, 246.752}},
                                         {"7", {112.422, 4.210, 245.289}},
                                         {"1", {61.048, 54.004, 245.882}},
                                         {"10", {54.932, 114.162, 246.650}},
                                         {"11", {60.065, 91.742, 246.796}},
                                         {"12", {40.803, 142.655, 246.762}},
                                         {"13", {87.268, 118.633, 246.669}},
                                         {"14", {76.984, 136.066, 246.687}},
                                         {"15", {102.071, 93.194, 246.795}}}};
  return all;
}

/// Who is sighted from where: neighbours within 90 m, both ways, as in a network of inter-station sights. The fixed
/// ones, 0 and 3, do not see each other.
inline bool sees(size_t from, size_t to) {
  const Vec3 d = nails()[to].place - nails()[from].place;
  return from != to && std::hypot(d.x, d.y) < 90;
}

/// Errors in the field, in their order: of the instrument once a setup, of the target once a sight, of the angles and
/// the distance.
struct FieldNoise {
  RandomStream* random = nullptr;  ///< nullptr: none
  double normal() const { return random == nullptr ? 0 : random->normal(); }
};

/// The sights of a survey of all nails, measured with the noise of the settings. Fixed: nails 0 and 3, the others
/// without coordinates.
inline Survey observed(const NetworkSettings& s, FieldNoise noise, bool are_fixed = true) {
  Survey survey;
  for (size_t i = 0; i < nails().size(); ++i) {
    SurveyPoint point;
    point.id = nails()[i].id;
    if (are_fixed && (i == 0 || i == 3)) point.position = nails()[i].place, point.sigma_m = {};
    survey.points.push_back(point);
  }
  for (uint32_t from = 0; from < nails().size(); ++from) {
    survey.setups.push_back({"", from});
    const double orientation = 0.4 * from;
    const Vec3 off{s.sigma_centring_m * noise.normal(), s.sigma_centring_m * noise.normal(),
                   s.sigma_height_m * noise.normal()};
    for (uint32_t to = 0; to < nails().size(); ++to) {
      if (!sees(from, to)) continue;
      SurveySight sight;
      sight.line = survey.sightings.size() + 2;
      sight.setup = from;
      sight.target = to;
      sight.instrument_height_m = 1.6, sight.target_height_m = 1.4;
      const Vec3 stands{s.sigma_target_centring_m * noise.normal(),
                        s.sigma_target_centring_m * noise.normal(),
                        s.sigma_target_height_m * noise.normal()};
      const Vec3 d = nails()[to].place + stands - nails()[from].place - off + Vec3{0, 0, -0.2};
      const double level = std::hypot(d.x, d.y);
      const double drop = (1 - s.refraction) * level * level / (2 * s.earth_radius_m);
      sight.direction_rad =
          std::atan2(d.x, d.y) - orientation + s.sigma_direction_rad * noise.normal();
      sight.zenith_rad = std::atan2(level, d.z - drop) + s.sigma_zenith_rad * noise.normal();
      const double length = std::hypot(level / s.scale, d.z);
      sight.distance_m =
          length + (s.sigma_distance_m + 1e-6 * s.sigma_distance_ppm * length) * noise.normal();
      survey.sightings.push_back(sight);
    }
  }
  return survey;
}

}  // namespace jalon::test
