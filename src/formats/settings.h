// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

// Values stand in the order of the choices of their rows (option_rows.cpp).
/// What the polygons of a file become: as it says itself, a face each, or the triangles of a mesh.
enum class Polygons { kAuto, kFaces, kMesh };
enum class FileUnit { kAuto, kMetres, kFeet, kUsSurveyFeet, kMillimetres, kCentimetres };
enum class LasVersion { kAuto, k12, k14 };
enum class PlyForm { kLittleEndian, kBigEndian, kAscii };
enum class DxfVersion { kR12, kR2000 };
enum class DxfView { kWorld, kElevation };
enum class StlForm { kBinary, kAscii };
enum class PngBits { k16, k8 };

/// The options of the operation "read". Each reader takes those of its format.
struct ReadSettings {
  std::string format = "auto";  ///< a keyword of registry.h
  std::string columns;          ///< of a text file; "" = from its header, or guessed
  bool drop_invalid = false;
  Polygons polygons = Polygons::kAuto;
  FileUnit unit = FileUnit::kAuto;
  std::vector<double> box{};      ///< least x, y, z, then greatest; empty = all
  double spacing_m = 0;           ///< 0 = all points
  std::string station;            ///< name or number of the one whose points are read; "" = all
  int64_t max_points = 0;         ///< 0 = all
  std::string fields;             ///< names; "" = all, "-" = none
  double png_source_pixel_m = 0;  ///< of files that do not tell it, as the next two
  double png_step_m = 0;
  double png_zero_m = 0;

  /// All points of the file's octree, where it has one.
  bool reads_all() const { return box.empty() && spacing_m == 0; }
  /// All that the file has: nothing that is of clouds alone is told.
  bool reads_whole() const {
    return reads_all() && station.empty() && max_points == 0 && fields.empty();
  }
  /// The box, closed, or all space; Error(kInvalidArgument) where it is none.
  Box3 box_m() const;
};

/// The options of the operation "write".
struct WriteSettings {
  std::string format = "auto";
  LasVersion las_version = LasVersion::kAuto;
  double scale = 0;  ///< metres; 0 = as in the file that the cloud came from
  PlyForm ply_format = PlyForm::kLittleEndian;
  std::vector<double> png_direction{};  ///< toward the viewer; empty = upward
  double png_pixel_m = 0;               ///< 0 = two points a pixel on average
  PngBits png_bits = PngBits::k16;
  int decimals = -1;  ///< -1 = as many as give the same number back
  double chord_error_m = 0.001;
  DxfVersion dxf_version = DxfVersion::kR2000;
  DxfView dxf_view = DxfView::kWorld;
  std::string dxf_images;  ///< PNG files with world files, separated by '|'
  StlForm stl_format = StlForm::kBinary;
  double city_scale_m = 0.0001;
  double ifc_wall_thickness_m = 0;  ///< 0 = the measured surfaces
  double gpkg_plan_height_m = 1.2;  ///< above sills, below the lintels of doors
};

/// The options of the operation "convert": those of "read" and "write" that clouds have.
struct ConvertSettings {
  ReadSettings reading;
  WriteSettings writing;
};

}  // namespace jalon
