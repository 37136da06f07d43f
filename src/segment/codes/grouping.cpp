// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/grouping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/text_number.h"

namespace jalon {

namespace {

// Twice the precision of a survey in plan (1 to 3 mm in the source's), and its pole's.
constexpr double kRepeated_m = 0.01;

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

class Grouping {
 public:
  Grouping(const CodeTable& table, CodedObjects& out) : table_(table), out_(out) {}

  void add(const CodedPoint& point) {
    const CodeRow& row = *table_.find(point.sequence);
    if (row.geometry == CodeGeometry::kIgnored || is_repeated(row, point)) return;
    if (is_linkage(row.geometry)) link(row, point);
    else if (is_cylinder_point(row.geometry)) join_cylinder(row, point);
    else if (const size_t n = points_of_opening(row.geometry)) join_opening(row, point, n);
    else finish(begun(row, point));
  }

  void end() {
    for (auto& [sequence, object] : linkages_) finish(std::move(object));
    for (auto& [sequence, object] : openings_)
      incomplete(object, points_of_opening(object.row.geometry),
                 "; before it a point of this code may be missing or too many");
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

  void join_opening(const CodeRow& row, const CodedPoint& point, size_t wanted) {
    const auto [open, is_new] = openings_.try_emplace(point.sequence, begun(row, point));
    if (!is_new) open->second.points.push_back(point);
    if (open->second.points.size() < wanted) return;
    finish(std::move(open->second));
    openings_.erase(open);
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
  CodedObjects& out_;
  std::map<int64_t, CodedPoint> last_;                  // by sequence
  std::map<int64_t, CodedObject> linkages_, openings_;  // under way, by sequence
  CodedObject cylinder_;
};

}  // namespace

CodedObjects grouped_objects(const CodeList& list, const CodeTable& table) {
  CodedObjects out;
  out.warnings = list.warnings;
  if (list.points.empty()) return out;
  const Vec3& first = list.points.front().position;
  out.origin = {std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  Grouping grouping(table, out);
  for (const CodedPoint& point : list.points) grouping.add(point);
  grouping.end();
  std::stable_sort(out.objects.begin(), out.objects.end(),
                   [](const CodedObject& a, const CodedObject& b) {
                     return a.points.front().line < b.points.front().line;
                   });
  return out;
}

}  // namespace jalon
