// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/street_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/random.h"
#include "base/setting_rows.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr auto kStreetDriveRows = setting_rows(
    number_row<&StreetDriveSettings::leg_m>("leg_m", 40, 10000, "m", "", "Length of a leg."),
    bool_row<&StreetDriveSettings::corner>("corner", "", "Two legs, in an L; else one, straight."),
    bool_row<&StreetDriveSettings::closed>(
        "closed", "",
        "Houses with sides, backs and roofs, ground and things before them; else fronts alone."),
    number_row<&StreetDriveSettings::speed_m_s>("speed_m_s", 0.1, 60, "m/s", "", "Of the vehicle."),
    number_row<&StreetDriveSettings::epochs_per_s>("epochs_per_s", 0.1, 1000, "1/s", "",
                                                   "Epochs of the trajectory."),
    number_row<&StreetDriveSettings::sigma_position_m>("sigma_position_m", 1e-6, 100, "m", "",
                                                       "Of the trajectory: each coordinate."),
    number_row<&StreetDriveSettings::sigma_velocity_m_s>("sigma_velocity_m_s", 1e-9, 100, "m/s", "",
                                                         "Of the trajectory: each coordinate."),
    number_row<&StreetDriveSettings::sigma_attitude_rad>("sigma_attitude_rad", 1e-9, 1, "rad", "",
                                                         "Of the trajectory: each angle."),
    doubles_row<&StreetDriveSettings::shift_m>("shift_m", -1e9, 1e9, "m", "",
                                               "Three numbers added to all coordinates."),
    integer_row<&StreetDriveSettings::seed>("seed", 0, 1e15, "", "",
                                            "Of set-backs, turns, heights; of 0 set-backs and "
                                            "turns of -0.05, 0 and 0.05 rad follow each other."));

// Of the street: from its axis to the line of the fronts, between blocks, houses of a block, depth.
constexpr double kToFronts_m = 8, kBetween_m = 3, kDepth_m = 10;
constexpr int kHouses = 4, kOutside = 4, kInside = 3;
constexpr double kSetBack_m = 0.3, kMostTurn_rad = 0.05;
constexpr uint64_t kSetBacks = 5;
constexpr uint64_t kInTurn = 0;     // the seed of a street of which nothing but heights is drawn
constexpr double kVehicle_m = 1.2;  // the inertial unit above the ground

class StreetBuilder {
 public:
  StreetBuilder(const StreetDriveSettings& settings, const Vec3& shift)
      : settings_(settings), shift_(shift), random_(settings.seed, 0) {}

  // Blocks along a line: from "start" in the direction "way", fronts towards "out" (unit vectors).
  void side(const Vec3& start, const Vec3& way, const Vec3& out, double length, int blocks) {
    const double pitch = length / blocks, front = (pitch - kBetween_m) / kHouses;
    for (int b = 0; b < blocks; ++b)
      for (int h = 0; h < kHouses; ++h)
        house(start + way * (b * pitch + kBetween_m / 2 + h * front), way, out, front);
  }

  void ground(double from, double to) {
    const uint32_t number = part("ground", part_class::kGround);
    add(number, {{from, from, 0}, {to, from, 0}, {to, to, 0}, {from, to, 0}});
  }

  // A box that no model has: a van, a kiosk.
  void thing(const Vec3& middle, double along, double across, double height) {
    const uint32_t number = part("thing", part_class::kElement);
    const Vec3 a = middle + Vec3{-along / 2, -across / 2, 0},
               b = middle + Vec3{along / 2, -across / 2, 0},
               c = middle + Vec3{along / 2, across / 2, 0},
               d = middle + Vec3{-along / 2, across / 2, 0};
    prism({a, b, c, d}, height, number);
  }

  Model take() { return std::move(model_); }

 private:
  uint32_t part(const std::string& name, const char* part_class) {
    Part made;
    made.name = name + " " + std::to_string(model_.parts.size() + 1);
    made.part_class = part_class;
    made.level_of_detail = 2;
    model_.parts.push_back(std::move(made));
    return static_cast<uint32_t>(model_.parts.size() - 1);
  }

  void house(const Vec3& start, const Vec3& way, const Vec3& out, double front) {
    uint64_t setting = random_.below(kSetBacks);
    double turned = 2 * random_.uniform() - 1;
    if (settings_.seed == kInTurn) {
      setting = model_.parts.size() % kSetBacks;
      turned = static_cast<double>(model_.parts.size() % 3) - 1;
    }
    const double set_back = kSetBack_m * static_cast<double>(setting),
                 turn = kMostTurn_rad * turned;
    const double height = 9 + 6 * random_.uniform();
    const uint32_t number = part("house", part_class::kBuilding);
    const Vec3 middle = start + way * (front / 2) - out * set_back;
    const Vec3 half = rotation_of(turn, way) * (front / 2), a = middle - half, b = middle + half;
    // Seen from the street the way runs to the left or to the right: outward faces either way.
    const bool to_the_right =
        cross(way, Vec3{0, 0, 1}).x * out.x + cross(way, Vec3{0, 0, 1}).y * out.y > 0;
    const Vec3 left = to_the_right ? a : b, right = to_the_right ? b : a;
    if (!settings_.closed) {
      const Vec3 up{0, 0, height};
      add(number, {left, right, right + up, left + up});
      return;
    }
    prism({left, right, right - out * kDepth_m, left - out * kDepth_m}, height, number);
  }

  static Vec3 rotation_of(double turn, const Vec3& v) {
    return {v.x * std::cos(turn) - v.y * std::sin(turn),
            v.x * std::sin(turn) + v.y * std::cos(turn), 0};
  }

  // Four sides and a roof over a base that runs anticlockwise seen from above.
  void prism(const std::vector<Vec3>& base, double height, uint32_t number) {
    const Vec3 up{0, 0, height};
    std::vector<Vec3> roof;
    for (size_t k = 0; k < base.size(); ++k) {
      const Vec3 &a = base[k], &b = base[(k + 1) % base.size()];
      add(number, {a, b, b + up, a + up});
      roof.push_back(a + up);
    }
    add(number, roof);
  }

  void add(uint32_t number, std::vector<Vec3> corners) {
    for (Vec3& p : corners) p += shift_;
    Face face;
    face.part = number;
    face.id = static_cast<uint32_t>(model_.faces.size());
    face.plane.normal = normalized(newell_normal(corners));
    face.plane.offset = dot(face.plane.normal, corners[0]);
    face.area_m2 = norm(newell_normal(corners)) / 2;
    const size_t index = model_.add_face(face, {corners});
    for (const auto& triangle : triangles_of_face(model_, model_.faces[index])) {
      model_.triangles.push_back(triangle);
      model_.triangle_faces.push_back(face.id);
    }
  }

  const StreetDriveSettings& settings_;
  Vec3 shift_;
  RandomStream random_;
  Model model_;
};

// Along x, then along y, 5 m short of nothing: the corner is taken at once, the heading in two seconds.
Trajectory drive_of(const StreetDriveSettings& s, const Vec3& shift) {
  const double length = s.corner ? 2 * s.leg_m : s.leg_m, duration = length / s.speed_m_s;
  const auto steps = static_cast<size_t>(std::llround(duration * s.epochs_per_s));
  Trajectory made;
  for (size_t i = 0; i <= steps; ++i) {
    const double t = std::min(duration, static_cast<double>(i) / s.epochs_per_s),
                 way = s.speed_m_s * t;
    const double beyond = way - s.leg_m;
    made.times_s.push_back(t);
    made.positions.push_back(
        shift + (beyond <= 0 ? Vec3{way, 0, kVehicle_m} : Vec3{s.leg_m, beyond, kVehicle_m}));
    constexpr double kTurning_s = 2;
    const double turned =
        s.corner ? std::clamp(beyond / s.speed_m_s / kTurning_s + 0.5, 0.0, 1.0) : 0;
    made.attitudes_rad.push_back({0, 0, turned * std::numbers::pi / 2});
    made.position_sigmas_m.push_back(Vec3{1, 1, 1} * s.sigma_position_m);
    made.velocity_sigmas_m_s.push_back(Vec3{1, 1, 1} * s.sigma_velocity_m_s);
    made.attitude_sigmas_rad.push_back(Vec3{1, 1, 1} * s.sigma_attitude_rad);
  }
  return made;
}

}  // namespace

std::span<const ParamRow> street_drive_rows() { return kStreetDriveRows; }

StreetDrive street_drive(const StreetDriveSettings& settings) {
  if (settings.shift_m.size() != 3)
    fail(Status::kInvalidArgument, "shift_m needs three numbers, not %zu", settings.shift_m.size());
  const Vec3 shift{settings.shift_m[0], settings.shift_m[1], settings.shift_m[2]};
  const double leg = settings.leg_m, d = kToFronts_m;
  const Vec3 east{1, 0, 0}, north{0, 1, 0};
  StreetBuilder street(settings, shift);
  // Outside of the corner a leg is longer by the street's half width, inside shorter by that and a house's depth.
  const double outside = settings.corner ? leg + d : leg,
               inside = settings.corner ? leg - d - kDepth_m - 2 : leg;
  street.side({0, -d, 0}, east, north, outside, kOutside);
  street.side({0, d, 0}, east, -north, inside, kInside);
  if (settings.corner) {
    street.side({leg + d, leg - outside, 0}, north, -east, outside, kOutside);
    street.side({leg - d, leg - inside, 0}, north, east, inside, kInside);
  }
  if (settings.closed) {
    street.ground(-50, leg + 50);
    for (double x = 15; x < leg - 15; x += 22) street.thing({x, -5.5, 0}, 4.5, 1.8, 1.7);
    if (settings.corner)
      for (double y = 25; y < leg - 10; y += 31) street.thing({leg + 5.5, y, 0}, 1.8, 4.5, 2.4);
  }
  StreetDrive made{street.take(), drive_of(settings, shift)};
  return made;
}

}  // namespace jalon
