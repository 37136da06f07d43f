// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/code_lists.h"

#include <cmath>
#include <numbers>

#include "base/text_number.h"

namespace jalon::yard {

namespace {

constexpr uint64_t kSurveyStream = 1ull << 35;
constexpr int kDecimals = 4;           // tenths of a millimetre: lists round less than they err
constexpr double kTopOffset_m = 0.05;  // of the prism at a gutter's top from its axis

class SurveyBook {
 public:
  SurveyBook(const YardSettings& settings, uint64_t seed, const Transform& T_world_scene)
      : settings_(settings), random_(seed, kSurveyStream), T_world_scene_(T_world_scene) {
    const double angle = 2 * std::numbers::pi * random_.uniform();
    shift_ = Vec3{std::cos(angle), std::sin(angle), 0} * settings.georeference_m;
  }

  void add(const Vec3& place, const std::string& code) {
    Vec3 p = place + shift_;
    for (int axis = 0; axis < 3; ++axis) p[axis] += settings_.survey_noise_m * random_.normal();
    lines_.push_back(std::to_string(++number_) + ";" + coordinates(T_world_scene_, p) + ";" + code);
  }

  static std::string coordinates(const Transform& T_world_scene, const Vec3& p) {
    const Vec3 world = T_world_scene.point(p);
    return text_of(world.x, kDecimals) + ";" + text_of(world.y, kDecimals) + ";" +
           text_of(world.z, kDecimals);
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  const YardSettings& settings_;
  RandomStream random_;
  const Transform& T_world_scene_;
  Vec3 shift_;
  int number_ = 0;
  std::vector<std::string> lines_;
};

// The low point stands under the second corner, as in the list of the field.
void add_building(SurveyBook& book, const Building& b) {
  const std::string sequence = std::to_string(b.sequence);
  for (size_t k = 0; k < b.outline.size(); ++k) {
    const Vec2& p = b.outline[k];
    book.add({p.u, p.v, b.top_m}, sequence + (k == 0 ? ".2" : ".4"));
    if (k == 1) book.add({p.u, p.v, b.low_m}, sequence + ".4");
  }
}

// At the frame; from an oblique sight two corners at the wall and one of them again at the frame; with a sill that is
// inclined both its ends at the wall, then two corners at the frame.
void add_opening(SurveyBook& book, const Side& side, const Opening& o, int points) {
  const auto at = [&](double u, double v, double depth) { return side.wall.point(u, v, -depth); };
  const int first = o.is_door ? 350 : 360;
  const std::string code = std::to_string(first + points - 2);
  if (points == 2) {
    book.add(at(o.left_m, o.low_m, o.depth_m), code);
    book.add(at(o.right_m, o.high_m, o.depth_m), code);
  } else if (points == 3) {
    book.add(at(o.left_m, o.low_m, 0), code);
    book.add(at(o.left_m, o.low_m, o.depth_m), code + ".8");
    book.add(at(o.right_m, o.high_m, 0), code);
  } else {
    book.add(at(o.left_m, o.hole_low_m(), 0), code);
    book.add(at(o.right_m, o.hole_low_m(), 0), code);
    book.add(at(o.right_m, o.low_m, o.depth_m), code + ".8");
    book.add(at(o.right_m, o.high_m, o.depth_m), code + ".8");
  }
}

int points_of(const Side& side, const Opening& o) {
  if (o.is_door) return o.id % 2 == 0 ? 2 : 3;  // the survey has as many of either
  return side.building == 'B' || side.building == 'D' ? 4 : 3;
}

void add_gutter(SurveyBook& book, const Gutter& g, double shift_m) {
  const Vec2 along{-g.outward.v, g.outward.u};
  const auto at = [](const Vec2& p, double z) { return Vec3{p.u, p.v, z}; };
  book.add(at(g.centre + g.outward * shift_m, kGround_m), "408");
  book.add(at(g.centre + along * kGutterRadius_m, kGround_m), "409");
  book.add(at(g.centre + g.outward * kTopOffset_m, kGutterTop_m), "410");
}

}  // namespace

std::vector<std::string> survey_lines(const Plan& plan, const YardSettings& settings, uint64_t seed,
                                      const Transform& T_world_scene) {
  SurveyBook book(settings, seed, T_world_scene);
  for (const Building& b : plan.buildings) add_building(book, b);
  for (const Side& side : plan.sides)
    for (const Opening& o : side.openings) add_opening(book, side, o, points_of(side, o));
  double shift_m = settings.gutter_shift_m;
  for (const Gutter& g : plan.gutters) add_gutter(book, g, std::exchange(shift_m, 0));
  return book.take();
}

std::vector<std::string> target_lines(const Plan& plan, const Transform& T_world_scene) {
  std::vector<std::string> lines;
  for (const Target& t : plan.targets)
    lines.push_back(std::to_string(t.id) + ";" + SurveyBook::coordinates(T_world_scene, t.place) +
                    ";" + std::to_string(t.code));
  return lines;
}

}  // namespace jalon::yard
