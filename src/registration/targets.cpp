// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <map>
#include <vector>

#include "base/error.h"
#include "base/table_columns.h"
#include "registration/registration_tables.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    number_row("sigma_m", 0.003, 1e-9, 1e3, "m", "",
               "Standard deviation of each coordinate of targets that come without a covariance."),
};

struct Pair {
  size_t reference, moving;
};

std::vector<Pair> pairs_by_name(std::span<const Target> reference, std::span<const Target> moving) {
  std::map<std::string, size_t> at;
  for (size_t i = 0; i < reference.size(); ++i)
    if (!reference[i].name.empty() && !at.emplace(reference[i].name, i).second)
      fail(Status::kInvalidArgument, "two reference targets are named \"%.100s\"", reference[i].name.c_str());
  std::vector<Pair> pairs;
  for (size_t i = 0; i < moving.size(); ++i)
    if (const auto found = at.find(moving[i].name); found != at.end()) pairs.push_back({found->second, i});
  return pairs;
}

Vec3 centroid_of(std::span<const Target> targets, const std::vector<Pair>& pairs, size_t Pair::* side) {
  const Vec3 origin = targets[pairs[0].*side].xyz;
  Vec3 sum;
  for (const Pair& p : pairs) sum += targets[p.*side].xyz - origin;
  return origin + sum / static_cast<double>(pairs.size());
}

// Arun, Huang & Blostein 1987: the rotation from the singular vectors of the correlation of both sets about their
// centroids, proper by the sign of the last.
Transform rigid_motion_of(std::span<const Target> reference, std::span<const Target> moving,
                          const std::vector<Pair>& pairs, const Vec3& to, const Vec3& from) {
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (const Pair& p : pairs) {
    const Vec3 a = moving[p.moving].xyz - from, b = reference[p.reference].xyz - to;
    correlation += Eigen::Vector3d(b.x, b.y, b.z) * Eigen::RowVector3d(a.x, a.y, a.z);
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()(1) > 1e-12 * svd.singularValues()(0)))
    fail(Status::kDegenerate, "the targets lie on one line; a turn about it stays open: add one beside it");
  Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
  const Eigen::Matrix3d rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  Transform pose;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) pose.m[4 * i + j] = rotation(i, j);
  const Vec3 shift = to - pose.direction(from);
  for (size_t i = 0; i < 3; ++i) pose.m[4 * i + 3] = shift[static_cast<int>(i)];
  return pose;
}

}  // namespace

std::span<const ParamRow> targets_rows() { return kRows; }

Registration register_targets(std::span<const Target> reference, std::span<const Target> moving,
                              const ParamSet& params, Task& task) {
  task.checkpoint(0);
  const std::vector<Pair> pairs = pairs_by_name(reference, moving);
  if (pairs.size() < 3)
    fail(Status::kInsufficientData, "%zu targets are named in both sets; a pose needs 3", pairs.size());
  Registration out;
  out.centre = centroid_of(reference, pairs, &Pair::reference);
  out.pose = rigid_motion_of(reference, moving, pairs, out.centre, centroid_of(moving, pairs, &Pair::moving));
  out.converged = true;
  out.stopped = StopReason::kConverged;
  out.pairs = pairs.size();

  const double weight = 1 / (2 * params.number("sigma_m") * params.number("sigma_m"));
  Square<6> normal{};
  double squares = 0, gyration = 0;
  std::vector<double> residuals;
  for (const Pair& p : pairs) {
    const Vec3 d = out.pose.point(moving[p.moving].xyz) - reference[p.reference].xyz;
    const Vec3 arm = reference[p.reference].xyz - out.centre;
    out.pair_names.push_back(moving[p.moving].name);
    squares += squared_norm(d);
    gyration += squared_norm(arm);
    residuals.insert(residuals.end(), {d.x, d.y, d.z});
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 along;
      along[axis] = 1;
      const Vec3 turn = cross(arm, along);
      const Coefficients<6> row{turn.x, turn.y, turn.z, along.x, along.y, along.z};
      for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j) normal[6 * i + j] += weight * row[i] * row[j];
    }
  }
  const auto n = static_cast<double>(pairs.size());
  out.rms_m = std::sqrt(squares / n);
  out.extent_m = std::sqrt(gyration / n);
  Cholesky<6> factor;
  if (!factor.factor(normal)) fail(Status::kDegenerate, "the targets do not fix the pose");
  out.covariance = factor.inverse();
  out.residuals.set(make_column<double>(
      {.name = "residual", .components = 3, .unit = "m", .meaning = "moved minus reference"}, residuals));
  fill_tables(out, pose_directions(out.covariance, out.extent_m));
  return out;
}

}  // namespace jalon
