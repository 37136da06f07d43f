// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/gauge_pieces.h"

#include <cmath>
#include <numbers>

#include "capi/support/guard.h"
#include "geometry/rigid_motion.h"
#include "solid/motion.h"

namespace jalon::capi {

namespace {

constexpr uint64_t kMaxPieces = 1000;
constexpr uint64_t kMaxPoses = 10'000'000;
constexpr double kLargest_m = 1e6;  // of a piece

double positive(double size, uint64_t i) {
  if (!(size > 0 && size <= kLargest_m))
    fail(Status::kInvalidArgument, "a size of piece %llu is not between 0 and 1e6 m",
         static_cast<unsigned long long>(i));
  return size;
}

ConvexPiece hull_of(const jalon_gauge_piece& piece, const Transform& frame, const double* points,
                    uint64_t count, uint64_t i) {
  if (points == nullptr || piece.first > count || piece.count > count - piece.first)
    fail(Status::kInvalidArgument, "piece %llu wants hull points that are not there",
         static_cast<unsigned long long>(i));
  std::vector<Vec3> corners;
  for (uint64_t k = piece.first; k < piece.first + piece.count; ++k) {
    corners.push_back(frame.point({points[3 * k], points[3 * k + 1], points[3 * k + 2]}));
    if (!is_finite(corners.back()))
      fail(Status::kInvalidArgument, "hull point %llu is not finite",
           static_cast<unsigned long long>(k));
  }
  return ConvexPiece::hull(corners);
}

ConvexPiece piece_of(const jalon_gauge_piece& piece, const double* points, uint64_t count,
                     uint64_t i) {
  Transform frame = from_c(piece.frame);
  require_rigid(frame, ("the frame of piece " + std::to_string(i)).c_str());
  frame = orthonormal(frame);
  switch (piece.kind) {
    case JALON_GAUGE_BOX:
      return ConvexPiece::box(
          frame, {positive(piece.size.x, i), positive(piece.size.y, i), positive(piece.size.z, i)});
    case JALON_GAUGE_SPHERE:
      return ConvexPiece::sphere(frame.translation(), positive(piece.size.x, i));
    case JALON_GAUGE_CYLINDER:
      return ConvexPiece::cylinder(frame, positive(piece.size.x, i), positive(piece.size.z, i));
    case JALON_GAUGE_HULL:
      return hull_of(piece, frame, points, count, i);
    default:
      fail(Status::kInvalidArgument, "%d is no kind of piece: 1 box, 2 sphere, 3 cylinder, 4 hull",
           piece.kind);
  }
}

// Round outlines are chords of these many points: off by 0.12 % of the radius.
constexpr int kRoundPoints = 64;

double turn(int step) { return 2 * std::numbers::pi * step / kRoundPoints; }

std::vector<Vec3> box_corners(const Vec3& half) {
  std::vector<Vec3> out;
  for (const double x : {-half.x, half.x})
    for (const double y : {-half.y, half.y})
      for (const double z : {-half.z, half.z}) out.push_back({x, y, z});
  return out;
}

// Circles of latitude; the half ones of a meridian end in both poles.
std::vector<Vec3> sphere_points(double radius) {
  std::vector<Vec3> out;
  for (int latitude = 0; latitude <= kRoundPoints / 2; ++latitude)
    for (int step = 0; step < kRoundPoints; ++step) {
      const double ring = radius * std::sin(turn(latitude));
      out.push_back({ring * std::cos(turn(step)), ring * std::sin(turn(step)),
                     radius * std::cos(turn(latitude))});
    }
  return out;
}

std::vector<Vec3> cylinder_points(double radius, double length) {
  std::vector<Vec3> out;
  for (int step = 0; step < kRoundPoints; ++step)
    for (const double z : {-length / 2, length / 2})
      out.push_back({radius * std::cos(turn(step)), radius * std::sin(turn(step)), z});
  return out;
}

std::vector<Vec3> outline_points(const jalon_gauge_piece& piece, const double* points) {
  switch (piece.kind) {
    case JALON_GAUGE_BOX:
      return box_corners(from_c(piece.size) * 0.5);
    case JALON_GAUGE_SPHERE:
      return sphere_points(piece.size.x);
    case JALON_GAUGE_CYLINDER:
      return cylinder_points(piece.size.x, piece.size.z);
    default:
      break;
  }
  std::vector<Vec3> out;
  for (uint64_t k = piece.first; k < piece.first + piece.count; ++k)
    out.push_back({points[3 * k], points[3 * k + 1], points[3 * k + 2]});
  return out;
}

}  // namespace

std::vector<ConvexPiece> gauge_of(const jalon_gauge_piece* pieces, uint64_t count,
                                  const double* points, uint64_t point_count) {
  if (count == 0 || count > kMaxPieces)
    fail(Status::kInvalidArgument, "%llu pieces; a gauge has 1 to 1000",
         static_cast<unsigned long long>(count));
  require(pieces, "pieces");
  if (point_count > 0) require_array(points, JALON_FLOAT64, point_count, 3, 0, "hull_points");
  std::vector<ConvexPiece> gauge;
  for (uint64_t i = 0; i < count; ++i) gauge.push_back(piece_of(pieces[i], points, point_count, i));
  return gauge;
}

std::vector<Transform> pose_list(const jalon_transform* poses, uint64_t count) {
  if (count == 0 || count > kMaxPoses)
    fail(Status::kInvalidArgument, "%llu poses; a trajectory has 1 to 10 000 000",
         static_cast<unsigned long long>(count));
  require(poses, "poses");
  std::vector<Transform> out;
  for (uint64_t i = 0; i < count; ++i) out.push_back(from_c(poses[i]));
  return out;
}

std::vector<std::vector<Vec3>> gauge_outlines(const jalon_gauge_piece* pieces, uint64_t count,
                                              const double* points, uint64_t point_count) {
  (void)gauge_of(pieces, count, points, point_count);  // says what is wrong with them
  std::vector<std::vector<Vec3>> out;
  for (uint64_t i = 0; i < count; ++i) {
    const Transform frame = orthonormal(from_c(pieces[i].frame));
    out.push_back(outline_points(pieces[i], points));
    for (Vec3& p : out.back()) p = frame.point(p);
  }
  return out;
}

}  // namespace jalon::capi
