// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/placing.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "formats/dxf/sections.h"
#include "formats/files/utf8.h"
#include "model/chords.h"

namespace jalon::dxf {

namespace {

constexpr int kMostLevels = 32;  // blocks within blocks; a block within itself has no end
// Corners that all blocks stand for: some always, and so many for each byte of the file (a corner written takes 20).
constexpr uint64_t kCornersAtLeast = 50000, kCornersAByte = 16;
constexpr double kRound = 1e-9;       // of a scale: within it a circle stays one
constexpr double kChordShare = 1e-3;  // of the arc's chord, of arcs that become ellipses

struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, shift;
  Vec3 turn(const Vec3& p) const { return x * p.x + y * p.y + z * p.z; }
  Vec3 operator()(const Vec3& p) const { return turn(p) + shift; }
  Affine operator*(const Affine& b) const {
    return {turn(b.x), turn(b.y), turn(b.z), (*this)(b.shift)};
  }
};

// DXF Reference, INSERT: scaled, turned about the axis of its object coordinates, moved.
Affine placement(const Insert& insert, const Vec3& base, int64_t column, int64_t row) {
  const ObjectAxes axes = object_axes(insert.normal);
  const double c = std::cos(insert.rotation_rad), s = std::sin(insert.rotation_rad);
  const auto turned = [&](const Vec3& p) {
    return axes.x * (c * p.x - s * p.y) + axes.y * (s * p.x + c * p.y) + axes.z * p.z;
  };
  Affine out;
  out.x = turned({insert.scale.x, 0, 0});
  out.y = turned({0, insert.scale.y, 0});
  out.z = turned({0, 0, insert.scale.z});
  const Vec3 step{static_cast<double>(column) * insert.column_step,
                  static_cast<double>(row) * insert.row_step, 0};
  out.shift = axes.x * insert.at.x + axes.y * insert.at.y + axes.z * insert.at.z + turned(step) -
              out.turn(base);
  return out;
}

// Arcs of a loop as chords, in its own plane.
Loop with_chords_of(const Loop& loop) {
  Loop out = loop;
  out.corners.clear();
  for (size_t i = 0; i < loop.corners.size(); ++i) {
    const Vec3 &a = loop.corners[i], &b = loop.corners[(i + 1) % loop.corners.size()];
    out.corners.push_back(a);
    if (loop.bulges[i] == 0 || a == b) continue;
    const double chord = norm(b - a);
    for (const Vec3& p :
         arc_points(a, b, loop.bulges[i] * chord / 2, loop.normal, kChordShare * chord))
      out.corners.push_back(p);
  }
  out.bulges.assign(out.corners.size(), 0);
  return out;
}

Loop placed(const Loop& given, const Affine& to) {
  Loop out = given;
  if (norm(given.normal) > 0) {
    const ObjectAxes axes = object_axes(given.normal);
    const Vec3 x = to.turn(axes.x), y = to.turn(axes.y);
    const double scale = std::max(norm(x), norm(y));
    const bool is_round = std::fabs(norm(x) - norm(y)) <= kRound * scale &&
                          std::fabs(dot(x, y)) <= kRound * scale * scale;
    if (!is_round && std::ranges::any_of(given.bulges, [](double b) { return b != 0; }))
      out = with_chords_of(given);
    const Vec3 across = cross(x, y);
    out.normal = norm(across) > 0 ? normalized(across) : Vec3{};
  }
  for (Vec3& p : out.corners) p = to(p);
  return out;
}

class Placer {
 public:
  Placer(const Blocks& blocks, const Taker& taker, const DrawingFile& file, Task& task)
      : blocks_(blocks),
        taker_(taker),
        file_(file),
        task_(task),
        most_(kCornersAtLeast + kCornersAByte * file.bytes) {}

  void place(const Shapes& shapes, const Affine* to, const std::string& layer, int level) {
    if (level > kMostLevels)
      fail(Status::kFormat, "%.400s: blocks stand in each other more than %d deep",
           file_.path.c_str(), kMostLevels);
    task_.checkpoint(0.9);
    const auto layer_of = [&](const std::string& own) {
      return level > 0 && own == "0" ? layer : own;
    };
    for (const Loop& loop : shapes.loops) {
      Loop out = to != nullptr ? placed(loop, *to) : loop;
      count(out.corners.size());  // with the chords of arcs
      out.layer = layer_of(loop.layer);
      taker_.loop(std::move(out));
    }
    for (const Patch& patch : shapes.patches) {
      count(patch.corners.size());
      Patch out = patch;
      if (to != nullptr)
        for (Vec3& p : out.corners) p = (*to)(p);
      out.layer = layer_of(patch.layer);
      taker_.patch(std::move(out));
    }
    for (const Insert& insert : shapes.inserts) {
      count(1);
      const auto block = blocks_.find(lower(insert.block));
      if (block == blocks_.end()) {
        taker_.missing(insert.block);
        continue;
      }
      for (int64_t row = 0; row < std::max<int64_t>(insert.rows, 1); ++row)
        for (int64_t column = 0; column < std::max<int64_t>(insert.columns, 1); ++column) {
          count(1);
          const Affine own = placement(insert, block->second.base, column, row);
          const Affine whole = to != nullptr ? *to * own : own;
          place(block->second, &whole, layer_of(insert.layer), level + 1);
        }
    }
  }

 private:
  // What has no corners takes time all the same.
  void count(size_t corners) {
    corners_ += std::max<size_t>(corners, 1);
    if (corners_ > most_)
      fail(Status::kLimit, "%.400s: blocks in blocks stand for more than %llu corners",
           file_.path.c_str(), static_cast<unsigned long long>(most_));
  }
  const Blocks& blocks_;
  const Taker& taker_;
  const DrawingFile& file_;
  Task& task_;
  uint64_t corners_ = 0, most_;
};

}  // namespace

void place(const Shapes& shapes, const Blocks& blocks, const Taker& taker, const DrawingFile& file,
           Task& task) {
  Placer(blocks, taker, file, task).place(shapes, nullptr, "0", 0);
}

}  // namespace jalon::dxf
