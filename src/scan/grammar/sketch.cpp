// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/sketch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/polygon2.h"

namespace jalon::grammar {

namespace {

constexpr double kPier_m = 0.08;  // least wall between two openings, and between one and the border
constexpr double kLeastOpening_m = 0.25;

PlannedOpening flat_opening(double middle_u, double low_v, double width_m, double height_m,
                            OpeningClass opening_class) {
  PlannedOpening out;
  out.shape =
      Shape::flat({middle_u - width_m / 2, middle_u + width_m / 2, low_v, low_v + height_m});
  out.opening_class = opening_class;
  return out;
}

bool overlap(const Rect& a, const Rect& b, double margin_m) {
  return a.u0 < b.u1 + margin_m && b.u0 < a.u1 + margin_m && a.v0 < b.v1 + margin_m &&
         b.v0 < a.v1 + margin_m;
}

double distance_from_edge(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  return norm(p - a - d * std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0));
}

/// Inside the outline by the pier; at its foot it may stand on the border.
bool lies_inside(const Outline& outline, const Contour& contour) {
  const double foot = bounds_of(contour).v0;
  for (const Vec2& p : chords_of(contour)) {
    const bool at_foot = p.v == foot;
    if (!contains(outline, {p.u, p.v + (at_foot ? kPier_m / 2 : 0)})) return false;
    for (size_t k = 0; k < outline.size(); ++k) {
      const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
      const bool is_under = at_foot && a.v == p.v && b.v == p.v;
      if (!is_under && distance_from_edge(p, a, b) < kPier_m) return false;
    }
  }
  return true;
}

}  // namespace

std::pair<double, int> Sketch::sizes(double least_m, double most_m, int fewest, int most) {
  const double length = dice_.length(least_m, most_m);
  const int floors = dice_.count(fewest, most);
  plan_.width_m = asked_.front_m > 0 ? asked_.front_m : length;
  return {plan_.width_m, asked_.floors > 0 ? static_cast<int>(asked_.floors) : floors};
}

void Sketch::storeys(int count, double ground_m, double upper_m, double shrink) {
  plan_.floors_m = {0};
  double height = ground_m;
  for (int k = 0; k < count; ++k) {
    plan_.floors_m.push_back(plan_.floors_m.back() + height);
    height = k == 0 ? upper_m : height * shrink;
  }
}

size_t Sketch::wall(std::string name, double y_m, Contour outline) {
  plan_.walls.push_back({std::move(name), y_m, std::move(outline), {}, {}, true});
  return plan_.walls.size() - 1;
}

bool Sketch::is_free(const PlannedWall& wall, const Contour& contour) const {
  const Rect box = bounds_of(contour);
  if (std::min(box.width(), box.height()) < kLeastOpening_m) return false;
  if (!lies_inside(chords_of(wall.outline), contour)) return false;
  return std::none_of(wall.openings.begin(), wall.openings.end(), [&](const PlannedOpening& o) {
    return overlap(box, bounds_of(contour_of(o.shape)), kPier_m);
  });
}

bool Sketch::open(size_t wall, PlannedOpening opening) {
  if (!is_free(at(wall), contour_of(opening.shape))) return false;
  at(wall).openings.push_back(std::move(opening));
  return true;
}

bool Sketch::window(size_t wall, const WindowStyle& style, double middle_u, int storey) {
  const double v0 = floor(storey) + style.sill_m;
  const Rect rect{middle_u - style.width_m / 2, middle_u + style.width_m / 2, v0,
                  v0 + style.height_m};
  PlannedOpening o;
  switch (style.form) {
    case Shape::Form::kArched:
      o.shape = Shape::arched(rect, std::min(style.rise_m, style.width_m / 2));
      break;
    case Shape::Form::kPointed:
      o.shape = Shape::pointed(rect);
      break;
    case Shape::Form::kRound:
      o.shape = Shape::round({middle_u, v0 + style.width_m / 2}, style.width_m / 2);
      break;
    default:
      o.shape = Shape::flat(rect);
  }
  o.depth_m = style.depth_m;
  o.storey = storey;
  o.surround_m = style.surround_m;
  o.proud_m = style.proud_m;
  o.has_sill = style.has_sill;
  o.has_shutters = style.has_shutters;
  o.filling.mullions = style.mullions;
  o.filling.transoms = style.transoms;
  if (dice_.chance(style.blinds)) o.filling.blind_share = dice_.length(0.1, 1, 0.1);
  if (dice_.chance(style.curtains)) o.filling.curtain_share = dice_.chance(0.5) ? 1 : 0.4;
  o.filling.mirrors = plan_.has_gaps && dice_.chance(0.05);
  return open(wall, std::move(o));
}

void Sketch::window_row(size_t wall, const WindowStyle& style, const std::vector<double>& axes,
                        int storey, double blind_axes) {
  for (const double u : axes)
    if (!dice_.chance(blind_axes)) window(wall, style, u, storey);
}

bool Sketch::door(size_t wall, double middle_u, double width_m, double height_m, double depth_m) {
  PlannedOpening o;
  const Rect rect{middle_u - width_m / 2, middle_u + width_m / 2, 0, height_m};
  const bool is_arched = dice_.chance(0.2);
  o.shape = is_arched ? Shape::arched(rect, dice_.chance(0.4) ? width_m / 2 : 0.15 * width_m)
                      : Shape::flat(rect);
  o.opening_class = OpeningClass::kDoor;
  o.depth_m = depth_m;
  o.filling.kind = dice_.chance(0.7) ? Filling::Kind::kLeaf : Filling::Kind::kSash;
  o.filling.frame_m = 0.1;
  o.filling.mullions = width_m > 1.3 ? 1 : 0;
  o.filling.stall_m = 0.4;
  return open(wall, std::move(o));
}

bool Sketch::shop_front(size_t wall, double u0, double u1, double height_m, double depth_m) {
  PlannedOpening o;
  o.shape = Shape::flat({u0, u1, 0, height_m});
  o.opening_class = OpeningClass::kShopFront;
  o.depth_m = depth_m;
  o.filling.mullions = std::max(1, static_cast<int>((u1 - u0) / dice_.between(1.0, 1.8)));
  o.filling.transoms = dice_.chance(0.4) ? 1 : 0;
  o.filling.stall_m = dice_.chance(0.7) ? dice_.length(0.2, 0.7) : 0;
  o.filling.frame_m = 0.08;
  return open(wall, std::move(o));
}

bool Sketch::vent(size_t wall, double middle_u, double low_v, double width_m, double height_m) {
  PlannedOpening o = flat_opening(middle_u, low_v, width_m, height_m, OpeningClass::kVent);
  o.depth_m = dice_.between(0.08, 0.2);
  o.filling.kind = Filling::Kind::kLouvre;
  return open(wall, std::move(o));
}

bool Sketch::niche(size_t wall, double middle_u, double low_v, double width_m, double height_m) {
  PlannedOpening o = flat_opening(middle_u, low_v, width_m, height_m, OpeningClass::kOther);
  o.depth_m = dice_.between(0.04, 0.12);
  o.filling.kind = Filling::Kind::kClosed;
  return open(wall, std::move(o));
}

size_t Sketch::recess(size_t wall, const Rect& rect, double depth_m, int storey) {
  PlannedOpening o;
  o.shape = Shape::flat(rect);
  o.opening_class = OpeningClass::kRecess;
  o.depth_m = depth_m;
  o.storey = storey;
  o.filling.kind = Filling::Kind::kRecess;
  if (!open(wall, std::move(o))) return SIZE_MAX;
  return this->wall("recess " + std::to_string(plan_.walls.size()), at(wall).y_m + depth_m,
                    jalon::contour_of(rect));
}

bool Sketch::is_free_of_pads(const PlannedWall& wall, const Rect& rect) const {
  return std::none_of(wall.pads.begin(), wall.pads.end(),
                      [&](const Pad& p) { return overlap(rect, bounds_of(p.outline), -1e-9); });
}

bool Sketch::add_pad(PlannedWall& wall, Pad pad) {
  const Rect box = bounds_of(pad.outline);
  if (!is_free_of_pads(wall, box)) return false;
  for (const PlannedOpening& o : wall.openings) {
    const Rect b = bounds_of(contour_of(o.shape));
    const bool is_hole = std::any_of(pad.holes.begin(), pad.holes.end(), [&](const Contour& h) {
      return overlap(bounds_of(h), b, -1e-6);
    });
    if (!is_hole && overlap(box, b, -1e-9)) return false;
  }
  const Outline outline = chords_of(wall.outline);
  for (const Vec2& p :
       {Vec2{box.u0, box.v0}, Vec2{box.u1, box.v0}, Vec2{box.u1, box.v1}, Vec2{box.u0, box.v1}}) {
    const Vec2 middle{(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2};
    if (!contains(outline, p + (middle - p) * 0.01)) return false;
  }
  wall.pads.push_back(std::move(pad));
  return true;
}

bool Sketch::pad(size_t wall, const char* part_class, const Rect& rect, double low_m,
                 double high_m) {
  return add_pad(at(wall), {part_class, jalon::contour_of(rect), {}, low_m, high_m});
}

bool Sketch::brace(size_t wall, const Vec2& foot, const Vec2& head, double width_m,
                   double proud_m) {
  const double w = width_m;
  if (head.u - foot.u < 2 * w || head.v - foot.v < 2 * w) return false;
  return add_pad(
      at(wall),
      {"timber", {{foot}, {{foot.u + w, foot.v}}, {head}, {{head.u - w, head.v}}}, {}, 0, proud_m});
}

void Sketch::trim(PlannedWall& wall, const PlannedOpening& o) {
  const Rect box = bounds_of(contour_of(o.shape));
  if (o.surround_m > 0) {
    const bool on_ground = box.v0 == bounds_of(wall.outline).v0;
    Pad pad{"surround", contour_of(grown(o.shape, o.surround_m, on_ground)), {}, 0, o.proud_m};
    if (on_ground) pad.outline = notched(pad.outline, {contour_of(o.shape)});
    else pad.holes = {contour_of(o.shape)};
    add_pad(wall, std::move(pad));
  }
  if (o.has_sill && o.surround_m == 0)
    add_pad(wall, {"sill",
                   jalon::contour_of({box.u0 - 0.08, box.u1 + 0.08, box.v0 - 0.08, box.v0}),
                   {},
                   0,
                   dice_.between(0.05, 0.12)});
  if (o.has_shutters)
    for (const double u : {box.u0 - box.width() / 2 - 0.02, box.u1 + 0.02})
      add_pad(
          wall,
          {"shutter", jalon::contour_of({u, u + box.width() / 2, box.v0, box.v1}), {}, 0, 0.045});
}

void Sketch::finish() {
  for (size_t wall = 0; wall < plan_.walls.size(); ++wall) finish(wall);
}

void Sketch::finish(size_t wall) {
  const std::vector<PlannedOpening> openings = at(wall).openings;
  for (const PlannedOpening& o : openings) trim(at(wall), o);
}

std::vector<double> Sketch::axes(double u0, double u1, int count) const {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(u0 + (u1 - u0) * (i + 0.5) / count);
  return out;
}

std::vector<double> Sketch::axes_by(double u0, double u1, double least_m, double most_m) {
  return axes(
      u0, u1,
      std::max(1, static_cast<int>(std::lround((u1 - u0) / dice_.between(least_m, most_m)))));
}

}  // namespace jalon::grammar
