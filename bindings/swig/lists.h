/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Lists of C structs and handles, filled piece by piece: no language lays out C structs. */
#ifndef JALON_BINDINGS_LISTS_H
#define JALON_BINDINGS_LISTS_H

#include <deque>

#include "small_arrays.h"

namespace jalon_binding {

/** The convex pieces of a gauge. frame: T_gauge_piece (12 or 16 numbers), nullptr = identity. */
class Gauge {
 public:
  void add_box(const ArrayIn* size, const ArrayIn* frame = nullptr) {
    const Numbers12 edges(size, 1, 3, "size");
    add(JALON_GAUGE_BOX, frame, edges.as<jalon_vec3>());
  }
  void add_sphere(double radius_m, const ArrayIn* frame = nullptr) {
    const jalon_vec3 size = {radius_m, 0, 0};
    add(JALON_GAUGE_SPHERE, frame, &size);
  }
  void add_cylinder(double radius_m, double length_m, const ArrayIn* frame = nullptr) {
    const jalon_vec3 size = {radius_m, 0, length_m};
    add(JALON_GAUGE_CYLINDER, frame, &size);
  }
  void add_hull(const ArrayIn* points, const ArrayIn* frame = nullptr) {
    const Packed<double> packed(points, 3, "points");
    const std::uint64_t first = hull_.size() / 3;
    add(JALON_GAUGE_HULL, frame, nullptr);
    pieces_.back().first = first;
    pieces_.back().count = packed.count();
    hull_.insert(hull_.end(), packed.data(), packed.data() + packed.count() * 3);
  }
  std::uint64_t count() const { return pieces_.size(); }

  const jalon_gauge_piece* pieces() const { return pieces_.data(); }
  const double* hull() const { return hull_.data(); }
  std::uint64_t hull_count() const { return hull_.size() / 3; }

 private:
  void add(std::int32_t kind, const ArrayIn* frame, const jalon_vec3* size) {
    const Numbers12 pose(frame, 3, 4, "frame");
    jalon_gauge_piece piece = {};
    piece.kind = kind;
    piece.frame = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    if (frame != nullptr) piece.frame = *pose.as<jalon_transform>();
    if (size != nullptr) piece.size = *size;
    pieces_.push_back(piece);
  }

  std::vector<jalon_gauge_piece> pieces_;
  std::vector<double> hull_;
};

/** Points known in one frame. */
class Targets {
 public:
  /** name may be nullptr; covariance: 9 numbers (m2), or nullptr = the parameter "sigma_m" on each axis. */
  void add(const char* name, const ArrayIn* xyz, const ArrayIn* covariance = nullptr) {
    const Numbers12 point(xyz, 1, 3, "xyz"), spread(covariance, 3, 3, "covariance");
    if (xyz == nullptr) throw Failure{JALON_ERROR_INVALID_ARGUMENT, "xyz must be given"};
    jalon_target target = {};
    if (name != nullptr) {
      names_.emplace_back(name);
      target.name = names_.back().c_str();
    }
    target.xyz = *point.as<jalon_vec3>();
    if (covariance != nullptr)
      std::memcpy(target.covariance, spread.as<double>(), sizeof target.covariance);
    targets_.push_back(target);
  }
  std::uint64_t count() const { return targets_.size(); }
  const jalon_target* data() const { return targets_.data(); }

 private:
  std::deque<std::string> names_;  // its texts stay where they are
  std::vector<jalon_target> targets_;
};

/** Several clouds as one argument. */
class CloudList {
 public:
  void add(Handle<jalon_cloud>* cloud) {
    const Use<jalon_cloud> use(cloud);
    owned_.emplace_back(jalon_cloud_retain(use));
    clouds_.push_back(use);
  }
  std::uint64_t count() const { return clouds_.size(); }
  jalon_cloud* const* data() const { return clouds_.data(); }

 private:
  std::deque<Owned<jalon_cloud>> owned_;
  std::vector<jalon_cloud*> clouds_;
};

}  // namespace jalon_binding

#endif
