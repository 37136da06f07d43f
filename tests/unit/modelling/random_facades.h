// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "base/random.h"
#include "modelling/facade/plan.h"
#include "modelling/plane/ring_tools.h"
#include "segment/segmentation.h"

namespace facades {

using namespace jalon;

/// Facades drawn at random, as the 2D models of their planes and a few points behind, in front of and beside their
/// openings: walls with windows, doors and round heads, planes that overlap, grounds, sills and cornices, all a little
/// out of true.
class RandomFacade {
 public:
  explicit RandomFacade(uint64_t seed) : random_(seed, 11) {
    const int walls = 1 + static_cast<int>(3 * random_.uniform());
    Vec3 corner{100 * random_.uniform(), 100 * random_.uniform(), 10 * random_.uniform()};
    double azimuth = 6.2 * random_.uniform();
    for (int i = 0; i < walls; ++i) {
      const double width = 3 + 15 * random_.uniform();
      const Vec3 along{std::cos(azimuth), std::sin(azimuth), 0};
      add_wall(corner, along, width, 3 + 9 * random_.uniform());
      corner += along * (width + between(-0.05, 0.05));
      if (random_.uniform() < 0.7) azimuth += between(-1.6, 1.6);
    }
    if (random_.uniform() < 0.7) add_ground(corner);
  }

  Segmentation segmentation() {
    Segmentation out;
    auto labels = std::make_shared<Column>(FieldInfo{"label", ElementType::kUint32, 1, "", ""},
                                           points_.size());
    Buffer<double> xyz(3 * points_.size());
    for (size_t i = 0; i < points_.size(); ++i) {
      for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points_[i][k];
      labels->values<uint32_t>()[i] = labels_[i];
    }
    out.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
    out.labels = labels;
    out.segments = segments_;
    return out;
  }
  const std::vector<VectorPlane>& planes() const { return planes_; }

 private:
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }

  static VectorRing ring_of(std::vector<Vec2> corners) {
    VectorRing ring;
    ring.corners = std::move(corners);
    ring.edges.resize(ring.corners.size());
    for (VectorEdge& edge : ring.edges) edge.sigma_m = 0.003;
    return ring;
  }

  // An upright opening, clockwise, its head straight, segmental or semicircular.
  VectorRing hole(double left, double bottom, double width, double height) {
    const double tilt = between(-0.01, 0.01);
    VectorRing ring = ring_of({{left, bottom},
                               {left + tilt, bottom + height},
                               {left + width + tilt, bottom + height},
                               {left + width, bottom + tilt}});
    const double kind = random_.uniform();
    if (kind < 0.4) ring.edges[1].sagitta_m = -width * (kind < 0.2 ? 0.5 : between(0.05, 0.4));
    return ring;
  }

  size_t add_plane(const Plane& plane, const Vec3& origin) {
    Segment segment;
    segment.label = static_cast<uint32_t>(segments_.size() + 1);
    segment.fit.plane = plane;
    segment.fit.sigma = 0.003;
    segment.fit.n = 0;
    segment.fit.axis_u = normalized(cross({0.3, 0.2, 1}, plane.normal));
    segment.fit.axis_v = cross(plane.normal, segment.fit.axis_u);
    segment.fit.centroid = origin;
    segment.fit.local_covariance = {1e-8, 0, 0, 1e-8, 0, 1e-8};
    update_covariance(segment.fit);
    segments_.push_back(segment);
    VectorPlane out;
    out.label = segment.label;
    out.frame = plane_frame(
        plane, {std::floor(origin.x), std::floor(origin.y), std::floor(origin.z)}, {1, 0, 0});
    out.spacing_m = 0.05;
    planes_.push_back(out);
    return planes_.size() - 1;
  }

  // A plane upright to the horizontal direction, leaning by up to half a degree.
  Plane leaning(const Vec3& outward, const Vec3& through) {
    const Vec3 n = normalized(
        outward + Vec3{between(-0.009, 0.009), between(-0.009, 0.009), between(-0.009, 0.009)});
    return {n, dot(n, through)};
  }

  void put(size_t plane, const Vec3& p, uint32_t label) {
    points_.push_back(p);
    labels_.push_back(label);
    if (plane < segments_.size()) ++segments_[plane].fit.n;
  }

  void add_wall(const Vec3& corner, const Vec3& along, double width, double height) {
    const Vec3 outward{along.y, -along.x, 0};
    const size_t wall = add_plane(leaning(outward, corner), corner);
    const Vec2 low = planes_[wall].frame.project(corner);
    has_door_ = height > 4 && random_.uniform() < 0.5;
    VectorFace face{ring_of(outline(low, width, height)), {}};
    const int columns = static_cast<int>(width / 2), rows = static_cast<int>(height / 2.8);
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        if (random_.uniform() < 0.25 || (has_door_ && i == 0 && j == 0)) continue;
        const VectorRing ring = hole(low.u + 0.5 + 2 * i + between(-0.15, 0.15),
                                     low.v + 0.7 + 2.7 * j, between(0.5, 1.3), between(0.6, 1.25));
        face.openings.push_back(ring);
        fill(wall, ring, outward);
      }
    planes_[wall].faces.push_back(std::move(face));
    if (random_.uniform() < 0.5) add_cornice(wall, low, width, height, outward);
  }

  // A rectangle, or a gable, or with a doorway in its lower border.
  std::vector<Vec2> outline(const Vec2& low, double width, double height) {
    const auto at = [&](double u, double v) {
      return Vec2{low.u + u + between(-0.01, 0.01), low.v + v + between(-0.01, 0.01)};
    };
    std::vector<Vec2> out{at(0, 0)};
    if (has_door_) {
      const double left = between(0.4, 0.8), top = between(1.8, 2.3), door = between(0.8, 1.2);
      out.push_back(at(left, 0));
      out.push_back(at(left, top));
      out.push_back(at(left + door, top));
      out.push_back(at(left + door, 0));
    }
    out.push_back(at(width, 0));
    out.push_back(at(width, height));
    if (random_.uniform() < 0.3) out.push_back(at(width / 2, height + 2));
    out.push_back(at(0, height));
    return out;
  }

  // Behind an opening: a pane, points of nothing, or nothing; or something in front.
  void fill(size_t wall, const VectorRing& ring, const Vec3& outward) {
    const PlaneFrame frame = planes_[wall].frame;
    const RingBox box = ring_box(ring);
    const double kind = random_.uniform(), depth = between(0.04, 0.5);
    const Vec3 middle = frame.lift(box.middle());
    size_t pane = ~size_t{0};
    if (kind < 0.6) {
      pane = add_plane(leaning(outward, middle - frame.normal * depth), middle);
      const Vec2 p = planes_[pane].frame.project(middle);
      const double u = box.width() / 2, v = box.height() / 2;
      planes_[pane].faces.push_back(
          {ring_of({p + Vec2{-u, -v}, p + Vec2{u, -v}, p + Vec2{u, v}, p + Vec2{-u, v}}), {}});
    }
    const double w = kind < 0.6 ? -depth : kind < 0.75 ? 0.5 : -0.9;
    if (kind > 0.9) return;
    for (double u = box.low.u + 0.02; u < box.high.u; u += 0.05)
      for (double v = box.low.v + 0.02; v < box.high.v; v += 0.05)
        put(pane, frame.lift({u, v}) + frame.normal * w,
            pane < segments_.size() ? segments_[pane].label : 0);
  }

  void add_cornice(size_t wall, const Vec2& low, double width, double height, const Vec3& outward) {
    const Vec3 foot = planes_[wall].frame.lift({low.u, low.v + height});
    const size_t cornice = add_plane(leaning(outward, foot + outward * between(0.05, 0.4)), foot);
    const Vec2 p = planes_[cornice].frame.project(foot);
    planes_[cornice].faces.push_back(
        {ring_of({p, p + Vec2{width, 0}, p + Vec2{width, 0.4}, p + Vec2{0, 0.4}}), {}});
    const size_t soffit = add_plane({{0, 0, -1}, -foot.z + between(-0.01, 0.01)}, foot);
    const PlaneFrame frame = planes_[soffit].frame;
    std::vector<Vec2> ring;
    for (const auto& [along, out] : {std::pair{0.0, 0.01}, {0.0, 0.4}, {width, 0.4}, {width, 0.01}})
      ring.push_back(frame.project(foot + Vec3{-outward.y, outward.x, 0} * along + outward * out));
    VectorRing closed = ring_of(ring);
    if (signed_area(closed) < 0) closed = reversed(closed);
    planes_[soffit].faces.push_back({closed, {}});
  }

  void add_ground(const Vec3& near) {
    const size_t ground = add_plane({{0, 0, 1}, near.z + between(-0.02, 0.02)}, near);
    const Vec2 p = planes_[ground].frame.project(near);
    planes_[ground].faces.push_back(
        {ring_of({p + Vec2{-20, -20}, p + Vec2{20, -20}, p + Vec2{20, 20}, p + Vec2{-20, 20}}),
         {}});
  }

  RandomStream random_;
  bool has_door_ = false;  ///< in the first column of the wall being drawn
  std::vector<Segment> segments_;
  std::vector<VectorPlane> planes_;
  std::vector<Vec3> points_;
  std::vector<uint32_t> labels_;
};

}  // namespace facades
