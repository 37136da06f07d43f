// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/grouping.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <span>
#include <utility>

#include "base/text_number.h"
#include "segment/codes/openings.h"

namespace jalon {

namespace {

// Twice the precision of a survey in plan (1 to 3 mm in the source's), and its pole's.
constexpr double kRepeated_m = 0.01;
// Corners at one height are those of two openings; surveyed ones are 0.5 to 2.1 m high and up to 2 m wide.
constexpr double kLowestOpening_m = 0.2, kWidestOpening_m = 6;

bool is_linkage(CodeGeometry g) {
  return g == CodeGeometry::kPrism || g == CodeGeometry::kOutline || g == CodeGeometry::kPipe ||
         g == CodeGeometry::kLine;
}

// Points of an opening that is measured by a fixed number of them; 0: another geometry.
size_t points_of_opening(CodeGeometry g) {
  if (g == CodeGeometry::kTwoCorners || g == CodeGeometry::kWindowTarget) return 2;
  if (g == CodeGeometry::kThreePoints) return 3;
  return g == CodeGeometry::kFourPoints ? 4 : 0;
}

bool is_cylinder_point(CodeGeometry g) {
  return g == CodeGeometry::kCylinderCentre || g == CodeGeometry::kCylinderEdge ||
         g == CodeGeometry::kCylinderTop;
}

// How little a run of points looks like one opening.
struct Misfit {
  size_t odd = 0;     // no opening
  size_t turned = 0;  // measured another way than the one before it
  friend auto operator<=>(const Misfit&, const Misfit&) = default;
};

// Openings of one sequence when what is left over of its points stands at a place.
class Partings {
 public:
  Partings(std::span<const CodedPoint> points, size_t wanted, const CodeTable& table,
           const ArePaired& are_paired)
      : objects_(points.size() / wanted) {
    const size_t left_over = points.size() % wanted;
    for (size_t g = 0; g < objects_; ++g)
      for (const bool is_behind : {false, true}) {
        const auto group = points.subspan(g * wanted + (is_behind ? left_over : 0), wanted);
        (is_behind ? behind_ : before_).push_back(looks_of(group, table, are_paired));
      }
  }

  /// Of each place, 0 to the number of openings, what it makes of them, with sums from both ends.
  std::vector<Misfit> misfits() const {
    std::vector<Misfit> from_start(objects_ + 1), to_end(objects_ + 1);
    for (size_t g = 0; g < objects_; ++g)
      from_start[g + 1] = plus(from_start[g], before_[g], g > 0 ? &before_[g - 1] : nullptr);
    for (size_t g = objects_; g-- > 0;)
      to_end[g] = plus(to_end[g + 1], behind_[g], g + 1 < objects_ ? &behind_[g + 1] : nullptr);
    for (size_t k = 0; k <= objects_; ++k) {
      const bool is_inside = k > 0 && k < objects_;
      to_end[k].odd += from_start[k].odd;
      to_end[k].turned +=
          from_start[k].turned + (is_inside && before_[k - 1].way != behind_[k].way);
    }
    return to_end;
  }

 private:
  struct Looks {
    bool is_odd = false;
    size_t way = 0;  // in which it was measured: upward or not, and where its recessed twin stands
  };

  static Looks looks_of(std::span<const CodedPoint> group, const CodeTable& table,
                        const ArePaired& are_paired) {
    if (table.find(group[0].sequence)->geometry == CodeGeometry::kWindowTarget)
      return {are_paired && !are_paired(group[0], group[1]), 0};
    const OpeningCorners corners = opening_corners(group, table.modifiers.offset);
    const Vec3 across = corners.b - corners.a;
    const bool is_odd = !corners.fault.empty() || std::fabs(across.z) < kLowestOpening_m ||
                        norm(in_plan(across)) > kWidestOpening_m;
    const auto twin = std::find_if(group.begin(), group.end(), [&](const CodedPoint& p) {
      return p.modifier == table.modifiers.offset;
    });
    return {is_odd, 2 * static_cast<size_t>(twin - group.begin()) + (across.z > 0)};
  }

  static Misfit plus(Misfit sum, const Looks& looks, const Looks* neighbour) {
    sum.odd += looks.is_odd;
    sum.turned += neighbour != nullptr && neighbour->way != looks.way;
    return sum;
  }

  size_t objects_;
  std::vector<Looks> before_, behind_;  // with what is left over behind them, and before them
};

struct LeftOver {
  size_t at = 0;  ///< first point
  bool is_certain = false;
};

// Where what is left over stands: the place that leaves the openings before and behind it most like openings. Where
// several do so alike nothing tells which, and it is the last of them.
LeftOver find_left_over(std::span<const CodedPoint> points, size_t wanted, const CodeTable& table,
                        const ArePaired& are_paired) {
  const std::vector<Misfit> misfits = Partings(points, wanted, table, are_paired).misfits();
  const Misfit least = *std::min_element(misfits.begin(), misfits.end());
  const auto last = std::find(misfits.rbegin(), misfits.rend(), least);
  return {wanted * static_cast<size_t>(misfits.rend() - last - 1),
          std::count(misfits.begin(), misfits.end(), least) == 1};
}

class Grouping {
 public:
  Grouping(const CodeTable& table, const ArePaired& are_paired, CodedObjects& out)
      : table_(table), are_paired_(are_paired), out_(out) {}

  void add(const CodedPoint& point) {
    const CodeRow& row = *table_.find(point.sequence);
    if (row.geometry == CodeGeometry::kIgnored || is_repeated(row, point)) return;
    if (is_linkage(row.geometry)) link(row, point);
    else if (is_cylinder_point(row.geometry)) join_cylinder(row, point);
    else if (points_of_opening(row.geometry) > 0) openings_[point.sequence].push_back(point);
    else finish(begun(row, point));
  }

  void end() {
    for (auto& [sequence, object] : linkages_) finish(std::move(object));
    for (const auto& [sequence, points] : openings_) part_openings(points);
    if (!cylinder_.points.empty()) incomplete(cylinder_, kCylinderPoints);
  }

 private:
  static constexpr size_t kCylinderPoints = 3;

  // A point measured twice would make corners of two windows of all that follow it.
  bool is_repeated(const CodeRow& row, const CodedPoint& point) {
    if (row.geometry == CodeGeometry::kPoint) return false;
    const auto [before, is_first] = last_.try_emplace(point.sequence, point);
    const CodedPoint last = std::exchange(before->second, point);
    const double apart_m = norm(point.position - last.position);
    if (is_first || last.line == point.line || last.modifier != point.modifier ||
        apart_m > kRepeated_m)
      return false;
    out_.warnings.push_back({point.line, row.name + " " + point.id,
                             "lies " + text_of(1000 * apart_m, 0) + " mm from point " + last.id +
                                 " of line " + std::to_string(last.line) +
                                 ", which has the same code: measured twice, used once"});
    return true;
  }

  static CodedObject begun(const CodeRow& row, const CodedPoint& point) {
    CodedObject object;
    object.name = row.name + " " + point.id;
    object.row = row;
    object.points.push_back(point);
    return object;
  }

  void finish(CodedObject object) { out_.objects.push_back(std::move(object)); }

  void incomplete(const CodedObject& object, size_t wanted, const char* hint = "") {
    out_.warnings.push_back({object.points.back().line, object.name,
                             "has " + std::to_string(object.points.size()) + " of " +
                                 std::to_string(wanted) + " points: left out" + hint});
  }

  // A start ends the object before it; every other point belongs to the one that is under way.
  void link(const CodeRow& row, const CodedPoint& point) {
    const auto open = linkages_.find(point.sequence);
    if (point.modifier == table_.modifiers.start) {
      if (open != linkages_.end()) {
        finish(std::move(open->second));
        linkages_.erase(open);
      }
      linkages_.emplace(point.sequence, begun(row, point));
      return;
    }
    if (open == linkages_.end()) {
      out_.warnings.push_back({point.line, row.name + " " + point.id,
                               "stands before the start of its linkage: left out"});
      return;
    }
    open->second.points.push_back(point);
    if (point.modifier == table_.modifiers.close) {
      finish(std::move(open->second));
      linkages_.erase(open);
    }
  }

  // Openings of a fixed number of points each, in the order of the list; what is left over of them lacks a point, and
  // those behind it keep theirs.
  void part_openings(const std::vector<CodedPoint>& points) {
    const CodeRow& row = *table_.find(points.front().sequence);
    const size_t wanted = points_of_opening(row.geometry), left_over = points.size() % wanted;
    const LeftOver gap = left_over == 0 ? LeftOver{points.size(), true}
                                        : find_left_over(points, wanted, table_, are_paired_);
    for (size_t at = 0; at < points.size();) {
      const size_t count = at == gap.at ? left_over : wanted;
      CodedObject object = begun(row, points[at]);
      object.points.assign(points.begin() + static_cast<std::ptrdiff_t>(at),
                           points.begin() + static_cast<std::ptrdiff_t>(at + count));
      if (at == gap.at)
        incomplete(object, wanted,
                   at + count == points.size() && gap.is_certain ? ""
                   : gap.is_certain
                       ? "; those behind it keep their own"
                       : "; before it a point of this code may be missing or too many");
      else finish(std::move(object));
      at += count;
    }
  }

  // Centre, edge and top follow one another, whatever other sequences stand between them.
  void join_cylinder(const CodeRow& row, const CodedPoint& point) {
    const size_t place =
        static_cast<size_t>(row.geometry) - static_cast<size_t>(CodeGeometry::kCylinderCentre);
    if (place != cylinder_.points.size()) {
      if (!cylinder_.points.empty()) incomplete(cylinder_, kCylinderPoints);
      cylinder_ = {};
      if (place != 0) {
        out_.warnings.push_back(
            {point.line, row.name + " " + point.id, "has no centre before it: left out"});
        return;
      }
    }
    if (place == 0) cylinder_ = begun(row, point);
    else cylinder_.points.push_back(point);
    if (cylinder_.points.size() < kCylinderPoints) return;
    finish(std::move(cylinder_));
    cylinder_ = {};
  }

  const CodeTable& table_;
  const ArePaired& are_paired_;
  CodedObjects& out_;
  std::map<int64_t, CodedPoint> last_;       // by sequence
  std::map<int64_t, CodedObject> linkages_;  // under way, by sequence
  std::map<int64_t, std::vector<CodedPoint>> openings_;
  CodedObject cylinder_;
};

}  // namespace

CodedObjects grouped_objects(const CodeList& list, const CodeTable& table,
                             const ArePaired& are_paired) {
  CodedObjects out;
  out.warnings = list.warnings;
  if (list.points.empty()) return out;
  const Vec3& first = list.points.front().position;
  out.origin = {std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  Grouping grouping(table, are_paired, out);
  for (const CodedPoint& point : list.points) grouping.add(point);
  grouping.end();
  std::stable_sort(out.objects.begin(), out.objects.end(),
                   [](const CodedObject& a, const CodedObject& b) {
                     return a.points.front().line < b.points.front().line;
                   });
  return out;
}

}  // namespace jalon
