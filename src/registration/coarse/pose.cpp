// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/pose.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "registration/coarse/feature_histogram.h"

namespace jalon {

namespace {

constexpr double kPoseSameFacing = 0.8;  // cosine, 37 degrees: of normals of cells of two grids
constexpr float kAlike =
    0.2f;  // of the squared distance from the mean feature: 0.45 of the way there
constexpr double kDamping = 1e-4;   // keeps directions that nothing fixes where they are
constexpr size_t kLeastPairs = 12;  // two for each unknown

struct Found {
  uint32_t index = kNoPoint;
  double distance = 0, off_plane = 0;
};

// The cell of a surface nearest to a place, if it faces the same way.
Found partner(const CoarseSurface& surface, const Vec3& place, const Vec3& facing, double reach_m) {
  Found found;
  Neighbour near;
  if (!surface.tree->nearest_within(place, reach_m, near)) return found;
  const Vec3& normal = surface.normals[near.index];
  const bool is_flat = squared_norm(normal) > 0 && squared_norm(facing) > 0;
  if (is_flat && std::abs(dot(normal, facing)) < kPoseSameFacing) return found;
  found.index = near.index;
  found.distance = std::sqrt(near.squared_distance);
  found.off_plane =
      is_flat ? std::abs(dot(normal, place - surface.points[near.index])) : found.distance;
  return found;
}

}  // namespace

Transform closest_motion(std::span<const Vec3> from, std::span<const Vec3> to) {
  Vec3 a, b;
  for (size_t i = 0; i < from.size(); ++i) a += from[i], b += to[i];
  const auto n = static_cast<double>(from.size());
  a = a / n, b = b / n;
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < from.size(); ++i) {
    const Vec3 p = from[i] - a, q = to[i] - b;
    products += Eigen::Vector3d(q.x, q.y, q.z) * Eigen::RowVector3d(p.x, p.y, p.z);
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d turn =
      svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  Transform out;
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c)
      out.m[4 * r + c] = turn(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
  const Vec3 shift = b - out.direction(a);
  out.m[3] = shift.x, out.m[7] = shift.y, out.m[11] = shift.z;
  return out;
}

PoseJudge::PoseJudge(const CoarseSurface& reference, const CoarseSurface& moving, size_t most) {
  const auto side_of = [most](const CoarseSurface& s) {
    Side side{&s, {}, {}, 0};
    const size_t step = s.size() / most + 1;
    for (size_t i = 0; i < s.size(); i += step) {
      side.sample.push_back(static_cast<uint32_t>(i));
      side.weight += s.weights[i];
    }
    const size_t salient_step = s.salient.size() / most + 1;
    for (size_t i = 0; i < s.salient.size(); i += salient_step)
      side.salient.push_back(s.salient[i]);
    return side;
  };
  reference_ = side_of(reference);
  moving_ = side_of(moving);
  // Corners of a cube of the surface's spread stand for all of its points.
  const double half = moving.extent_m / std::sqrt(3.0);
  for (int k = 0; k < 8; ++k)
    corners_.push_back(moving.centroid +
                       Vec3{k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half});
}

PoseJudge::Laid PoseJudge::laid_on(const Side& side, const Transform& T_other_side,
                                   const CoarseSurface& other, double reach,
                                   double off_plane) const {
  const CoarseSurface& s = *side.surface;
  Laid out;
  for (const uint32_t i : side.sample) {
    const Found found = partner(other, T_other_side.point(s.points[i]),
                                T_other_side.direction(s.normals[i]), reach * other.cell_m);
    if (found.index == kNoPoint || found.off_plane > off_plane * other.cell_m) continue;
    out.weight += s.weights[i];
    out.squares += found.off_plane * found.off_plane;
    out.scatter += other.scatter_m2[found.index];
    ++out.n;
  }
  return out;
}

PoseJudge::Likeness PoseJudge::likeness(const Side& side, const Transform& T_other_side,
                                        const CoarseSurface& other, double reach) const {
  const CoarseSurface& s = *side.surface;
  std::vector<Neighbour> near;
  Likeness out;
  for (const uint32_t i : side.salient) {
    other.tree->radius(T_other_side.point(s.points[i]), reach * other.cell_m, near);
    if (near.empty()) continue;
    ++out.near;
    const float far = kAlike * squared_distance(s.features[i], s.mean_feature);
    const Vec3 facing = T_other_side.direction(s.normals[i]);
    out.alike += std::any_of(near.begin(), near.end(), [&](const Neighbour& n) {
      return std::abs(dot(facing, other.normals[n.index])) >= kPoseSameFacing &&
             squared_distance(s.features[i], other.features[n.index]) <= far;
    });
  }
  return out;
}

SurfaceOverlap PoseJudge::overlap(const Transform& T_reference_moving, double reach,
                                  double off_plane) const {
  const Transform T_moving_reference = inverse(T_reference_moving);
  const Laid forth = laid_on(moving_, T_reference_moving, *reference_.surface, reach, off_plane);
  const Laid back = laid_on(reference_, T_moving_reference, *moving_.surface, reach, off_plane);
  SurfaceOverlap out;
  out.of_moving = forth.weight / moving_.weight;
  out.of_reference = back.weight / reference_.weight;
  out.count = (forth.weight + back.weight) / (moving_.weight + reference_.weight);
  out.pairs = forth.n + back.n;
  if (out.pairs > 0) {
    out.rms_m = std::sqrt((forth.squares + back.squares) / static_cast<double>(out.pairs));
    out.scatter_m = std::sqrt((forth.scatter + back.scatter) / static_cast<double>(out.pairs));
  }
  const Likeness there = likeness(moving_, T_reference_moving, *reference_.surface, reach);
  const Likeness here = likeness(reference_, T_moving_reference, *moving_.surface, reach);
  const auto asked = static_cast<double>(moving_.salient.size() + reference_.salient.size());
  out.salient = static_cast<double>(there.near + here.near) / std::max(asked, 1.0);
  if (there.near + here.near > 0)
    out.likeness =
        static_cast<double>(there.alike + here.alike) / static_cast<double>(there.near + here.near);
  return out;
}

PoseJudge::Step PoseJudge::step(MotionModel& model, double reach) const {
  const CoarseSurface &from = *moving_.surface, &to = *reference_.surface;
  Step out;
  Square<6>& normal = out.normal;
  Coefficients<6> right{}, j;
  size_t n = 0;
  for (const uint32_t i : moving_.sample) {
    const Vec3 facing = model.motion().direction(from.normals[i]);
    const Found found =
        partner(to, model.motion().point(from.points[i]), facing, reach * to.cell_m);
    if (found.index == kNoPoint || squared_norm(to.normals[found.index]) == 0) continue;
    const double d =
        model.residual({from.points[i], to.points[found.index], to.normals[found.index]}, j);
    const double weight = from.weights[i] * std::max(0.05, 1 - 10 * to.variation[found.index]);
    ++n;
    for (size_t r = 0; r < 6; ++r) {
      right[r] -= weight * d * j[r];
      for (size_t c = 0; c < 6; ++c) normal[6 * r + c] += weight * j[r] * j[c];
    }
  }
  if (n < kLeastPairs) return out;
  Square<6> damped = normal;
  double turns = 0, shifts = 0;
  for (size_t i = 0; i < 3; ++i) turns += normal[7 * i], shifts += normal[7 * (i + 3)];
  for (size_t i = 0; i < 6; ++i) damped[7 * i] += kDamping * (i < 3 ? turns : shifts);
  Cholesky<6> factor;
  if (!factor.factor(damped)) return out;
  model.move(factor.solve(right));
  out.moved = true;
  return out;
}

SettledPose PoseJudge::settled(const Transform& T_reference_moving, double first, double last,
                               int iterations) const {
  MotionModel model(T_reference_moving, moving_.surface->centroid);
  Step last_step;
  for (int k = 0; k < iterations; ++k) {
    const double done = iterations > 1 ? static_cast<double>(k) / (iterations - 1) : 1;
    last_step = step(model, first * std::pow(last / first, done));
    if (!last_step.moved) break;
  }
  return {model.motion(), last_step.normal};
}

double PoseJudge::difference(const Transform& a, const Transform& b) const {
  double most = 0;
  for (const Vec3& p : corners_) most = std::max(most, norm(a.point(p) - b.point(p)));
  return most;
}

}  // namespace jalon
