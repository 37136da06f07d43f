// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/pipe_places.h"

#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "segment/codes/building_sides.h"

namespace jalon {

namespace {

constexpr size_t kPipePointsPerChunk = 1 << 15;
constexpr double kMostOff_m = 0.06;  // twice a prism held badly
constexpr double kOnPipe_m = 0.01;   // five times the noise of a scanner
constexpr size_t kFewestOnPipe = 40;
constexpr uint64_t kPipeDraws = 4;
constexpr int kRoundsInFront = 3;
constexpr double kLeastPart = 0.6, kMostPart = 1.6;  // of the surveyed radius

bool is_upright(const CodedObject& object) {
  return object.shape.kind == CodeShape::Kind::kPipe && object.shape.axis.size() == 2 &&
         in_plan(object.shape.axis[0]) == in_plan(object.shape.axis[1]);
}

// The weights of a fit may swing: another draw then.
bool fit_pipe(const std::vector<Vec2>& points, PrimitiveSetting setting, Task& task,
              CircleFit& fit) {
  if (points.size() < kFewestOnPipe) return false;
  for (setting.seed = 1; setting.seed <= kPipeDraws; ++setting.seed)
    if (fit_circle(points, setting, task, fit)) return fit.n >= kFewestOnPipe;
  return false;
}

std::vector<Vec2> in_front_of(const std::vector<Vec2>& points, const Circle& circle,
                              const Vec2& outward) {
  std::vector<Vec2> out;
  for (const Vec2& p : points)
    if (dot(p - circle.centre, outward) > -kPipeBackShare * circle.radius) out.push_back(p);
  return out;
}

// 1. the circle among what lies before the surveyed axis, or among all where that is none: a wave of the wall's sheet
// may be as round as the pipe; 2. again without what lies behind the side of it that is seen: the wall, where it stands
// as near as the pipe's back. outward: zero where no wall is known.
std::optional<PipePlace> place_of_pipe(const CodedObject& object, size_t number,
                                       const std::vector<Vec2>& points, const Vec2& outward,
                                       Task& task) {
  const CodeShape& shape = object.shape;
  PrimitiveSetting setting;
  setting.tolerance_m = kOnPipe_m;
  setting.min_radius_m = kLeastPart * shape.radius_m;
  setting.max_radius_m = kMostPart * shape.radius_m;
  const bool has_wall = dot(outward, outward) > 0;
  const Circle surveyed{in_plan(shape.axis[0]), shape.radius_m};
  CircleFit fit;
  if (!(has_wall && fit_pipe(in_front_of(points, surveyed, outward), setting, task, fit)) &&
      !fit_pipe(points, setting, task, fit))
    return std::nullopt;
  for (int round = 0; has_wall && round < kRoundsInFront; ++round) {
    CircleFit better;
    if (!fit_pipe(in_front_of(points, fit.circle, outward), setting, task, better)) break;
    fit = better;
  }
  const double off = norm(fit.circle.centre - in_plan(shape.axis[0]));
  if (off > kMostOff_m) return std::nullopt;
  return PipePlace{number, fit.circle, off};
}

}  // namespace

std::vector<PipePlace> pipe_places(const Cloud& cloud, const CodedObjects& objects, Task& task) {
  std::vector<size_t> pipes;
  for (size_t i = 0; i < objects.objects.size(); ++i)
    if (is_upright(objects.objects[i])) pipes.push_back(i);
  if (pipes.empty()) return {};
  std::vector<Vec2> outward;
  for (const size_t i : pipes)
    outward.push_back(way_out_at_pipe(objects, in_plan(objects.objects[i].shape.axis[0])));
  // 1. The points about each, chunk by chunk in their order. What lies farther behind its axis than its radius is its
  // wall: nobody sees the back of a pipe, and a wall that is scanned more densely would draw the circle to itself.
  const size_t chunks = (cloud.size() + kPipePointsPerChunk - 1) / kPipePointsPerChunk;
  std::vector<std::vector<std::pair<size_t, Vec2>>> found(chunks);
  parallel_for(task, cloud.size(), kPipePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i) - objects.origin;
      for (size_t k = 0; k < pipes.size(); ++k) {
        const CodeShape& shape = objects.objects[pipes[k]].shape;
        if (!(p.z > shape.low_m && p.z < shape.high_m)) continue;
        const Vec2 d = in_plan(p - shape.axis[0]);
        const double reach = shape.radius_m + kMostOff_m;
        if (dot(d, d) < reach * reach && dot(d, outward[k]) >= -shape.radius_m)
          found[begin / kPipePointsPerChunk].push_back({k, in_plan(p)});
      }
    }
  });
  // 2. The circle among them.
  std::vector<std::vector<Vec2>> points(pipes.size());
  for (const auto& part : found)
    for (const auto& [k, p] : part) points[k].push_back(p);
  std::vector<PipePlace> places;
  for (size_t k = 0; k < pipes.size(); ++k)
    if (auto place =
            place_of_pipe(objects.objects[pipes[k]], pipes[k], points[k], outward[k], task))
      places.push_back(*place);
  return places;
}

}  // namespace jalon
