// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Method "m3c2" written a second time, from its description, by loops over all points: nothing is shared with the
// library but the vectors.

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/vec.h"

namespace jalon::test {

struct SlowM3c2 {
  double normal_radius_m = 0.25, cylinder_radius_m = 0.15, max_depth_m = 1, gap_m = 0;
  bool median = true;
  size_t min_points = 5;
  double registration_error_m = 0;

  struct Result {
    Vec3 normal;
    double flatness =
        0;  ///< second eigenvalue over the first: near 0 the normal is a matter of rounding
    bool compared = false;
    double distance_m = 0, lod_m = 0;
    size_t count[2] = {0, 0};
  };
  struct Position {
    double at = 0, variance = 0, dof = 0;
  };

  void up_normal(const std::vector<Vec3>& points, const Vec3& centre, Result& out) const {
    std::vector<Eigen::Vector3d> near;
    for (const Vec3& p : points)
      if (norm(p - centre) <= normal_radius_m)
        near.emplace_back(p.x - centre.x, p.y - centre.y, p.z - centre.z);
    if (near.size() < 3) return;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : near) mean += p / static_cast<double>(near.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& p : near) scatter += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    out.normal = {n.x(), n.y(), n.z()};
    if (out.normal.z < 0) out.normal = -out.normal;
    out.flatness = (solver.eigenvalues()[1] - solver.eigenvalues()[0]) / solver.eigenvalues()[2];
  }

  std::vector<double> along(const std::vector<Vec3>& points, const Vec3& centre,
                            const Vec3& normal) const {
    std::vector<double> out;
    for (const Vec3& p : points) {
      const Vec3 d = p - centre;
      const double t = dot(d, normal);
      if (std::fabs(t) <= max_depth_m && norm(cross(d, normal)) <= cylinder_radius_m)
        out.push_back(t);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  // Connected groups of those with company, each with all between its ends.
  std::vector<std::vector<double>> groups(const std::vector<double>& t, double gap) const {
    std::vector<double> kept;
    for (const double a : t) {
      size_t company = 0;
      for (const double b : t) company += std::fabs(a - b) <= gap / 2;
      if (company >= std::max<size_t>(2, t.size() / 50)) kept.push_back(a);
    }
    std::vector<std::vector<double>> out;
    for (size_t i = 0, j = 0; i < kept.size(); i = j) {
      for (j = i + 1; j < kept.size() && kept[j] - kept[j - 1] <= gap;) ++j;
      std::vector<double> group;
      for (const double a : t)
        if (a >= kept[i] && a <= kept[j - 1]) group.push_back(a);
      if (group.size() >= min_points) out.push_back(group);
    }
    return out;
  }

  std::vector<std::vector<double>> surfaces(const std::vector<double>& t) const {
    if (t.size() < min_points) return {};
    if (gap_m == 0 || t.back() - t.front() <= gap_m) return {t};
    auto out = groups(t, gap_m);
    std::vector<double> largest = out.empty() ? t : out[0];
    for (const auto& group : out)
      if (group.size() > largest.size()) largest = group;
    double half = 1e300;
    const size_t h = largest.size() / 2;
    for (size_t i = 0; i + h < largest.size(); ++i)
      half = std::min(half, largest[i + h] - largest[i]);
    const double gap =
        5 * half / (2 * quartile()) * (1 + 5 / static_cast<double>(largest.size() - 1));
    return gap > gap_m ? groups(t, gap) : out;
  }

  static double quartile() { return boost::math::quantile(boost::math::normal(), 0.75); }
  static double middle(const std::vector<double>& t) {
    return t.size() % 2 == 1 ? t[t.size() / 2] : (t[t.size() / 2 - 1] + t[t.size() / 2]) / 2;
  }

  Position position(const std::vector<double>& t) const {
    const auto n = static_cast<double>(t.size());
    double mean = 0, squares = 0;
    for (const double v : t) mean += v / n;
    for (const double v : t) squares += (v - mean) * (v - mean);
    if (!median) return {mean, squares / (n - 1) / n, n - 1};
    const double c = std::max(1.0, std::round((n + 1) / 2 - std::sqrt(n)));
    const double high = t[t.size() - static_cast<size_t>(c)], low = t[static_cast<size_t>(c) - 1];
    const double expected =
        2 * boost::math::quantile(boost::math::normal(), (n + 0.625 - c) / (n + 0.25));
    const double of_median =
        std::sqrt(std::numbers::pi / 2 / (n + (t.size() % 2 == 1 ? 0.46 : 1.36)));
    const double dof = std::sqrt(n) + 2;
    return {middle(t), std::pow((high - low) / expected * of_median, 2) / (1 + 1 / (2 * dof)), dof};
  }

  Result at(const std::vector<Vec3>& reference, const std::vector<Vec3>& compared,
            const Vec3& core) const {
    Result out;
    up_normal(reference, core, out);
    if (out.flatness == 0) return out;
    const auto a = surfaces(along(reference, core, out.normal)),
               b = surfaces(along(compared, core, out.normal));
    if (a.empty() || b.empty()) return out;
    size_t i = nearest(a), j = nearest(b);
    if (to_core(a[i]) <= to_core(b[j])) j = nearest_to(b, middle(a[i]));
    else i = nearest_to(a, middle(b[j]));
    const Position p = position(a[i]), q = position(b[j]);
    const double v = p.variance + q.variance;
    const double dof = v * v / (p.variance * p.variance / p.dof + q.variance * q.variance / q.dof);
    out.compared = true;
    out.distance_m = q.at - p.at;
    out.lod_m = boost::math::quantile(boost::math::students_t(dof), 0.975) * std::sqrt(v) +
                boost::math::quantile(boost::math::normal(), 0.975) * registration_error_m;
    out.count[0] = a[i].size();
    out.count[1] = b[j].size();
    return out;
  }

  static double to_core(const std::vector<double>& t) {
    return std::max({0.0, t.front(), -t.back()});
  }
  static size_t nearest(const std::vector<std::vector<double>>& all) {
    size_t best = 0;
    for (size_t i = 0; i < all.size(); ++i)
      if (to_core(all[i]) < to_core(all[best])) best = i;
    return best;
  }
  static size_t nearest_to(const std::vector<std::vector<double>>& all, double anchor) {
    size_t best = 0;
    for (size_t i = 0; i < all.size(); ++i)
      if (std::fabs(middle(all[i]) - anchor) < std::fabs(middle(all[best]) - anchor)) best = i;
    return best;
  }
};

}  // namespace jalon::test
