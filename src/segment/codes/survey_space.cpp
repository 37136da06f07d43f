// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/survey_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr double kCell_m = 0.25;  // about the depth of a shell: most cells hold one object or none
constexpr double kMostCells = 2048;  // along a side: 16 MB of them at most

bool within(double x, double a, double b, double margin) {
  return x > std::min(a, b) - margin && x < std::max(a, b) + margin;
}

// Distance in plan from the upright plane through the shape's corners. A distance, not a side of the plane: which side
// a point is on says nothing, as the corners may be measured in either order.
double off_plane(const CodeShape& s, const Vec3& p) {
  const Vec2 along = in_plan(s.corner_b - s.corner_a);
  return std::fabs(cross(along, in_plan(p - s.corner_a))) / norm(along);
}

bool in_rectangle(const CodeShape& s, const Vec3& p, double margin, double distance) {
  const Vec3 &a = s.corner_a, &b = s.corner_b;
  return within(p.x, a.x, b.x, margin) && within(p.y, a.y, b.y, margin) &&
         within(p.z, a.z, b.z, margin) && off_plane(s, p) < distance;
}

bool in_outline(const CodeShape& s, const Vec3& p, double margin, double distance) {
  if (!(off_plane(s, p) < distance)) return false;
  const Vec2 along = in_plan(s.corner_b - s.corner_a);
  const Vec2 flat{dot(in_plan(p - s.corner_a), along) / norm(along), p.z};
  return contains(s.polygon, flat) || border_distance(s.polygon, flat) < margin;
}

bool in_pipe(const CodeShape& s, const Vec3& p, double margin) {
  const double radius = s.radius_m + margin;
  for (size_t i = 0; i + 1 < s.axis.size(); ++i) {
    const Vec3 along = s.axis[i + 1] - s.axis[i], d = p - s.axis[i];
    const double length = norm(along);
    if (length == 0) continue;
    const double t = dot(d, along) / (length * length);
    const bool first = i == 0, last = i + 2 == s.axis.size();
    if ((first && !(t > 0)) || (last && !(t < 1))) continue;  // no margin in length
    const Vec3 off = d - along * std::clamp(t, 0.0, 1.0);
    if (squared_norm(off) < radius * radius) return true;
  }
  return false;
}

}  // namespace

SurveySpace::SurveySpace(const CodeTable& table, const CodedObjects& objects,
                         const SurveyCodeSettings& settings)
    : settings_(settings) {
  for (size_t i = 0; i < objects.objects.size(); ++i)
    add(table, objects.objects[i], static_cast<uint32_t>(i + 1));
  std::stable_sort(spaces_.begin(), spaces_.end(),
                   [](const Space& a, const Space& b) { return a.rank < b.rank; });
  lay_grid();
}

void SurveySpace::add(const CodeTable& table, const CodedObject& object, uint32_t number) {
  const CodeShape& shape = object.shape;
  if (shape.kind == CodeShape::Kind::kNone) return;
  Space space{&shape, number, 0, object.row.distance_m, {}};
  double margin = settings_.opening_margin_m, height_margin = margin;
  if (shape.kind == CodeShape::Kind::kPipe) {
    ++pipes_;
    margin = shape.radius_m + settings_.pipe_margin_m;
    height_margin = 0;
    for (const Vec3& p : shape.axis) space.box.add({p.x, p.y, shape.low_m});
  } else if (shape.kind == CodeShape::Kind::kPrism) {
    ++prisms_;
    space.rank = 1;
    margin = settings_.outward_m;
    height_margin = settings_.height_margin_m;
    for (const Vec2& p : shape.polygon) space.box.add({p.u, p.v, shape.low_m});
  } else {
    const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                  [&](const CodeRow& r) { return r.from == object.row.from; });
    space.rank = 2 + static_cast<size_t>(row - table.rows.begin());
    margin = std::max(margin, space.distance_m);
    space.box.add(shape.corner_a);
    space.box.add(shape.corner_b);
  }
  space.box.min = {space.box.min.x - margin, space.box.min.y - margin, shape.low_m - height_margin};
  space.box.max = {space.box.max.x + margin, space.box.max.y + margin,
                   shape.high_m + height_margin};
  box_ += space.box;
  spaces_.push_back(space);
}

// Every cell lists the spaces that may reach into it, in the order in which they are asked.
void SurveySpace::lay_grid() {
  if (spaces_.empty()) return;
  const double width = box_.max.x - box_.min.x, depth = box_.max.y - box_.min.y;
  cell_m_ = std::max(kCell_m, std::max(width, depth) / kMostCells);
  columns_ = static_cast<size_t>(width / cell_m_) + 1;
  rows_ = static_cast<size_t>(depth / cell_m_) + 1;
  struct Entry {
    size_t cell;
    uint32_t space;
  };
  std::vector<Entry> entries;
  for (uint32_t i = 0; i < spaces_.size(); ++i)
    for_cells_of(spaces_[i], [&](size_t cell) { entries.push_back({cell, i}); });
  first_.assign(columns_ * rows_ + 1, 0);
  for (const Entry& entry : entries) ++first_[entry.cell + 1];
  for (size_t cell = 0; cell < columns_ * rows_; ++cell) first_[cell + 1] += first_[cell];
  members_.resize(entries.size());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Entry& entry : entries) members_[next[entry.cell]++] = entry.space;
}

template <class F>
void SurveySpace::for_cells_of(const Space& space, F&& f) const {
  const double reach = cell_m_ / std::numbers::sqrt2;  // from the middle of a cell to its corner
  const auto place = [&](double at, double from, size_t count) {
    return std::min(count - 1, static_cast<size_t>(std::max(0.0, (at - from) / cell_m_)));
  };
  const size_t x1 = place(space.box.max.x, box_.min.x, columns_),
               y1 = place(space.box.max.y, box_.min.y, rows_);
  for (size_t y = place(space.box.min.y, box_.min.y, rows_); y <= y1; ++y)
    for (size_t x = place(space.box.min.x, box_.min.x, columns_); x <= x1; ++x) {
      const Vec2 middle{box_.min.x + (static_cast<double>(x) + 0.5) * cell_m_,
                        box_.min.y + (static_cast<double>(y) + 0.5) * cell_m_};
      if (may_hold_in(space, middle, reach)) f(y * columns_ + x);
    }
}

bool SurveySpace::may_hold_in(const Space& space, const Vec2& middle, double reach) const {
  if (space.shape->kind != CodeShape::Kind::kPrism) return true;
  const double distance = border_distance(space.shape->polygon, middle);
  const bool inside = contains(space.shape->polygon, middle);
  return distance < reach + (inside ? settings_.inward_m : settings_.outward_m);
}

size_t SurveySpace::cell_of(double x, double y) const {
  const double column = (x - box_.min.x) / cell_m_, row = (y - box_.min.y) / cell_m_;
  if (!(column >= 0 && row >= 0)) return SIZE_MAX;
  if (column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return SIZE_MAX;
  return static_cast<size_t>(row) * columns_ + static_cast<size_t>(column);
}

bool SurveySpace::holds(const Space& space, const Vec3& p) const {
  const CodeShape& shape = *space.shape;
  switch (shape.kind) {
    case CodeShape::Kind::kPipe:
      return in_pipe(shape, p, settings_.pipe_margin_m);
    case CodeShape::Kind::kPrism: {
      const Vec2 at = in_plan(p);
      const double distance = border_distance(shape.polygon, at);
      return distance < (contains(shape.polygon, at) ? settings_.inward_m : settings_.outward_m);
    }
    case CodeShape::Kind::kRectangle:
      return in_rectangle(shape, p, settings_.opening_margin_m, space.distance_m);
    default:
      return in_outline(shape, p, settings_.opening_margin_m, space.distance_m);
  }
}

uint32_t SurveySpace::object_at(const Vec3& p) const {
  if (spaces_.empty() || !(p.z > box_.min.z && p.z < box_.max.z)) return 0;
  const size_t cell = cell_of(p.x, p.y);
  if (cell == SIZE_MAX) return 0;
  uint32_t found = 0;
  bool in_building = prisms_ == 0;
  for (uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
    const Space& space = spaces_[members_[k]];
    const bool is_prism = space.rank == 1;
    if (space.rank > 1 && !in_building) break;
    if (is_prism && in_building) continue;  // the first building keeps its points
    if (!(p.z > space.box.min.z && p.z < space.box.max.z) || !holds(space, p)) continue;
    found = space.object;
    if (space.rank == 0) break;
    in_building = true;
  }
  return found;
}

}  // namespace jalon
