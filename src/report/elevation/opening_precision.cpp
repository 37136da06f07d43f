// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/opening_precision.h"

#include <algorithm>
#include <cmath>

#include "report/elevation/face_rings.h"

namespace jalon {

namespace {

// Corners this near to a side of the box hold it.
constexpr double kOnSide_m = 0.002;
// A corner of the wall and the one behind it, in the plane of the wall: no joinery is that far out of its opening.
constexpr double kSameCorner_m = 0.02;

// Variance of a vertex along a unit direction.
double variance_along(const Model& model, uint32_t vertex, const Vec3& d) {
  const auto& c = model.vertex_covariances[vertex];
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) sum += d[i] * c[static_cast<size_t>(3 * i + k)] * d[k];
  return sum;
}

struct Corner {
  Vec2 at;
  uint32_t vertex;
};

// Of the corners farthest along d: mean of their variances along the axis, of those that have one; NaN for none.
double side_variance(const Model& model, const std::vector<Corner>& corners, const Vec3& axis,
                     const Vec2& d) {
  double most = -INFINITY;
  for (const Corner& c : corners) most = std::max(most, dot(c.at, d));
  double sum = 0;
  size_t n = 0;
  for (const Corner& c : corners) {
    const double variance = variance_along(model, c.vertex, axis);
    if (dot(c.at, d) < most - kOnSide_m || !std::isfinite(variance)) continue;
    sum += variance;
    ++n;
  }
  return sum / static_cast<double>(n);
}

void append_corners(std::vector<Corner>& out, const Model& model, const Ring& ring,
                    const PlaneFrame& frame) {
  for (uint64_t i = 0; i < ring.count; ++i) {
    const uint32_t vertex = model.corners[ring.first + i];
    out.push_back({frame.project(model.vertices[vertex]), vertex});
  }
}

// What closes a notch of the wall has its corners behind those of the wall, and these are the ones that were measured.
void move_to_wall(std::vector<Corner>& corners, const OpeningRow& row, const Model& model,
                  const PlaneFrame& frame) {
  std::vector<Corner> outline;
  append_corners(outline, model, model.rings[model.faces[row.wall].first_ring], frame);
  for (Corner& corner : corners) {
    const auto nearest =
        std::min_element(outline.begin(), outline.end(), [&](const Corner& a, const Corner& b) {
          return norm(a.at - corner.at) < norm(b.at - corner.at);
        });
    if (nearest != outline.end() && norm(nearest->at - corner.at) <= kSameCorner_m)
      corner = *nearest;
  }
}

void set_box_precision(OpeningRow& row, const Model& model) {
  const PlaneFrame frame = frame_of(model, model.faces[row.wall]);
  std::vector<Corner> corners;
  for (const FaceRing& at : row.contour)
    append_corners(corners, model, model.rings[at.ring], frame);
  if (row.wall != row.contour.front().face && model.faces[row.wall].ring_count > 0)
    move_to_wall(corners, row, model, frame);
  const auto sigma_across = [&](const Vec3& axis, const Vec2& d) {
    return std::sqrt(side_variance(model, corners, axis, d) +
                     side_variance(model, corners, axis, d * -1.0));
  };
  row.sigma_width_m = sigma_across(frame.axis_u, {1, 0});
  row.sigma_height_m = sigma_across(frame.axis_v, {0, 1});
}

bool has_covariance(const Face& face) {
  return std::any_of(face.covariance.begin(), face.covariance.end(),
                     [](double c) { return c != 0; });
}

// Joinery is the face behind the wall, not the outline itself.
void set_depth_precision(OpeningRow& row, const Model& model) {
  const Face& wall = model.faces[row.wall];
  const Ring& ring = model.rings[row.contour.front().ring];
  if (row.joinery.empty() || ring.count == 0) return;
  const Face& pane = model.faces[row.joinery.front()];
  if (&pane == &wall || !has_covariance(wall) || !has_covariance(pane)) return;
  Vec3 middle;
  for (uint64_t i = 0; i < ring.count; ++i)
    middle += model.vertices[model.corners[ring.first + i]] / static_cast<double>(ring.count);
  row.sigma_depth_m =
      std::hypot(sigma_at(wall.covariance, middle), sigma_at(pane.covariance, middle));
}

}  // namespace

double sigma_at(const std::array<double, 16>& covariance, const Vec3& p) {
  const double g[4] = {p.x, p.y, p.z, -1};  // distance = normal . p - offset
  double sum = 0;
  for (size_t i = 0; i < 4; ++i)
    for (size_t k = 0; k < 4; ++k) sum += g[i] * covariance[4 * i + k] * g[k];
  return std::sqrt(std::max(sum, 0.0));
}

void set_precision(OpeningRow& row, const Model& model) {
  if (row.contour.empty()) return;
  if (!model.vertex_covariances.empty()) set_box_precision(row, model);
  set_depth_precision(row, model);
}

}  // namespace jalon
