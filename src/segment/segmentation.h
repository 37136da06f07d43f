// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/numbers.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "geometry/cylinder.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "segment/orientation.h"

namespace jalon {

struct RansacSettings;   // ransac_settings.h
struct GrowingSettings;  // growing_settings.h

/// What a segment is; the numbers of jalon/segmenter.h (type codes of Boulaassal 2010, 5.5.2).
enum class PrimitiveType : uint8_t { kPlane = 1, kSphere = 2, kCylinder = 3 };

/// How the side of a plane's normal was found; the numbers of jalon/segmenter.h.
enum class FrontSource : uint8_t { kNone = 0, kStation = 1, kEvidence = 2 };

/// One architectural surface. Of the three fits the one of its type counts.
struct Segment {
  uint32_t label = 0;        ///< 1-based; points carry it
  int64_t source_label = 0;  ///< value in the field it was made from; 0: found by a method
  PrimitiveType type = PrimitiveType::kPlane;
  Orientation orientation = Orientation::kNone;  ///< kNone for spheres and cylinders
  PlaneFit fit;                                  ///< normal toward the viewer where known
  FrontSource front_source = FrontSource::kNone;
  double front_confidence = kNaN;  ///< the probability that the viewer was on the normal's side
  SphereFit sphere;
  CylinderFit cylinder;
  double area_m2 = 0;  ///< occupied raster cells
  /// Planes: extents along axis_u and axis_v; cylinders: along and around the axis.
  double length_u_m = 0, length_v_m = 0;

  bool is_plane() const { return type == PrimitiveType::kPlane; }
  /// A plane whose points define it: given labels may hold too few or collinear ones, and then the fit is NaN.
  bool has_plane() const { return is_plane() && std::isfinite(fit.plane.offset); }
  uint64_t point_count() const { return own(fit.n, sphere.n, cylinder.n); }
  double sigma_m() const { return own(fit.sigma, sphere.sigma, cylinder.sigma); }
  /// Signed distance of a point from the surface: in front of a plane, outside a sphere or cylinder.
  double distance(const Vec3& p) const {
    if (type == PrimitiveType::kSphere) return sphere.sphere.distance(p);
    return type == PrimitiveType::kCylinder ? cylinder.cylinder.distance(p) : fit.plane.distance(p);
  }

 private:
  template <class T>
  T own(T of_plane, T of_sphere, T of_cylinder) const {
    if (type == PrimitiveType::kSphere) return of_sphere;
    return type == PrimitiveType::kCylinder ? of_cylinder : of_plane;
  }
};

/// Number of the segments that are planes.
size_t plane_count(const std::vector<Segment>& segments);

/// Result of a segmenter: immutable, keeps its cloud.
struct Segmentation {
  CloudPtr cloud;
  ColumnPtr labels;     ///< "label" uint32: 0 = noise set, s = segments[s - 1]
  ColumnPtr residuals;  ///< "residual" float32, m, signed distance to the own plane; NaN for noise
  ColumnPtr orientations;         ///< "orientation" uint8
  std::vector<Segment> segments;  ///< largest first
  Transform T_facade_world;
  std::string parameters_json;  ///< what it was made with
  std::string notes_json;       ///< what a method by codes tells beside it; "" of the others
};

using SegmentationPtr = std::shared_ptr<const Segmentation>;

/// Parameter table of method "ransac".
std::span<const ParamRow> ransac_rows();
/// Sequential planes by seeded adaptive RANSAC (see ransac.cpp for the steps).
Segmentation segment_ransac(const CloudPtr& cloud, const RansacSettings& settings, Task& task);

/// Parameter table of method "region_growing".
std::span<const ParamRow> region_growing_rows();
/// Planes grown from the flattest places (see region_growing.cpp for the steps).
Segmentation segment_region_growing(const CloudPtr& cloud, const GrowingSettings& settings,
                                    Task& task);

}  // namespace jalon
