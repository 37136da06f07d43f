// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>

#include "segment/codes/opening_front.h"
#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr double kApart_m = 0.15;  // of frames along a facade: a narrow pier
constexpr double kSoughtIn =
    1.5;  // times the distance about a target's plane: where its front may be

// How far two targets of a facade may lie off their common plane, and the cosine of 20 degrees between it and the patch
// of 10 cm at each.
constexpr double kOneFacade_m = 0.05, kOneFacadeCosine = 0.94;

// The wall before a door or window shows on which side of their plane the outside is: the points of walls near the
// target, not the plane's own. 0: none lies there.
double outside_of(const TargetScene& scene, const Plane& plane, const Vec3& place, double reach_m) {
  constexpr double kAboutWall_m = 0.5;  // as between the two measurements of a corner
  double sum = 0;
  for (size_t i = 0; i < scene.owner.size(); ++i) {
    if (scene.owner[i] == 0) continue;
    const CodedObject& owner = scene.objects.objects[scene.owner[i] - 1];
    if (owner.row.geometry != CodeGeometry::kWallTarget) continue;
    const Vec3 p = scene.local(i);
    const double d = plane.distance(p);
    if (std::fabs(d) < kAboutWall_m && squared_norm(p - place) < reach_m * reach_m) sum += d;
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

// The plane through a place that stands upright: patches of 10 cm tell little of a lean.
Plane upright(const Plane& plane, const Vec3& place) {
  const Vec3 normal = normalized(Vec3{plane.normal.x, plane.normal.y, 0});
  return {normal, dot(normal, place)};
}

// What of one frame or leaf lies at its front and up to the distance behind it.
void add_at_front(std::span<const Vec3> flat, std::span<const uint32_t> points, double distance_m,
                  std::vector<uint32_t>& out) {
  OpeningFront front;
  if (!find_opening_front(flat, front)) return;
  for (size_t k = 0; k < points.size(); ++k) {
    const double before = flat[k].y - front.before(flat[k].x);
    if (before < kBeforeFront_m && before > -distance_m) out.push_back(points[k]);
  }
}

// Form "improved": the points about a plane, apart where nothing lies along it, each group by its own front: windows of
// one facade differ in depth by centimetres. at: the target's place along the plane where only its group counts.
std::vector<uint32_t> at_fronts(const TargetScene& scene, const Plane& plane, double outside,
                                double distance_m, std::vector<uint32_t> points,
                                const Vec3* only_at) {
  const Vec3 along = normalized(cross(Vec3{0, 0, 1}, plane.normal));
  const auto place = [&](uint32_t i) { return dot(scene.local(i), along); };
  std::stable_sort(points.begin(), points.end(),
                   [&](uint32_t a, uint32_t b) { return place(a) < place(b); });
  std::vector<uint32_t> out;
  for (size_t first = 0, end; first < points.size(); first = end) {
    std::vector<Vec3> flat;
    for (end = first; end < points.size(); ++end) {
      const double s = place(points[end]);
      if (!flat.empty() && s - flat.back().x > kApart_m) break;
      const Vec3 p = scene.local(points[end]);
      flat.push_back({s, outside * plane.distance(p), p.z});
    }
    const double target = only_at != nullptr ? dot(*only_at, along) : flat.front().x;
    if (target < flat.front().x - kApart_m || target > flat.back().x + kApart_m) continue;
    add_at_front(flat, std::span(points).subspan(first, end - first), distance_m, out);
  }
  return out;
}

// The points of an opening about its plane, among those that keep() takes; only_at: of one opening, its target's place.
template <class Keep>
std::vector<uint32_t> opening_points(const TargetScene& scene, const CodedObject& object,
                                     Plane plane, double reach_m, const Vec3* only_at, Keep&& keep,
                                     Task& task) {
  const Vec3 place = scene.place(object.points.front());
  const bool is_improved = scene.settings.input.form == CodeForm::kImproved;
  const double outside = is_improved ? outside_of(scene, plane, place, reach_m) : 0;
  if (outside != 0) plane = upright(plane, place);
  const double distance = object.row.distance_m * (outside != 0 ? kSoughtIn : 1);
  std::vector<uint32_t> points = free_points(
      scene, [&](const Vec3& p) { return std::fabs(plane.distance(p)) < distance && keep(p); },
      task);
  if (outside == 0) return points;
  return at_fronts(scene, plane, outside, object.row.distance_m, std::move(points), only_at);
}

void take_door(TargetScene& scene, uint32_t number, Task& task) {
  const CodedObject& object = scene.objects.objects[number - 1];
  const CodedPoint& target = object.points.front();
  const auto plane = plane_of(scene, patch_of(scene, target, false, task));
  if (!plane)
    return warn_of_target(
        scene, object,
        "fewer than three free points lie at its target: flush with its wall, or hidden");
  const Vec3 centre = scene.place(target);
  const double most = scene.settings.door_radius_m * scene.settings.door_radius_m;
  for (const uint32_t i : opening_points(
           scene, object, *plane, scene.settings.door_radius_m, &centre,
           [&](const Vec3& p) { return squared_norm(p - centre) < most; }, task))
    scene.owner[i] = number;
}

// Strictly between two places, widened by the margin, along every axis.
bool between(const Vec3& p, const Vec3& a, const Vec3& b, double margin) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] > std::min(a[k], b[k]) - margin && p[k] < std::max(a[k], b[k]) + margin))
      return false;
  return true;
}

void take_facade(TargetScene& scene, uint32_t number, Task& task) {
  const CodedObject& object = scene.objects.objects[number - 1];
  std::vector<uint32_t> patch;
  std::vector<Plane> own;
  for (const CodedPoint& target : object.points) {
    const std::vector<uint32_t> part = patch_of(scene, target, false, task);
    patch.insert(patch.end(), part.begin(), part.end());
    const auto plane = plane_of(scene, part);
    if (!plane)
      return warn_of_target(scene, object,
                            "fewer than three free points lie at target " + target.id);
    own.push_back(*plane);
  }
  const auto plane = plane_of(scene, patch);
  const Vec3 a = scene.place(object.points[0]), b = scene.place(object.points[1]);
  const auto agrees = [&](const Vec3& place, const Plane& patch_plane) {
    return std::fabs(plane->distance(place)) < kOneFacade_m &&
           std::fabs(dot(plane->normal, patch_plane.normal)) > kOneFacadeCosine;
  };
  if (!plane || !agrees(a, own[0]) || !agrees(b, own[1]))
    return warn_of_target(scene, object, "its two targets are on no common plane: left out");
  for (const uint32_t i : opening_points(
           scene, object, *plane, norm(b - a), nullptr,
           [&](const Vec3& p) { return between(p, a, b, scene.settings.window_margin_m); }, task))
    scene.owner[i] = number;
}

}  // namespace

void take_doors(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kDoorTarget)
      take_door(scene, number, task);
}

void take_windows(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kWindowTarget)
      take_facade(scene, number, task);
}

}  // namespace jalon
