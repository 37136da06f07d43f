// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/las/fields.h"
#include "formats/las/layout.h"
#include "formats/settings.h"

namespace jalon::las {

/// A field that goes into a standard dimension.
struct StandardColumn {
  ColumnPtr column;
  Place place;
};

/// A field, or one component of it, that goes into the extra bytes at this offset of the record.
struct ExtraColumn {
  ColumnPtr column;
  size_t offset = 0;
  uint32_t component = 0,
           components = 1;  ///< the components written: [component, component + components)
  bool scaled = false;
  ElementType raw_type = ElementType::kUint8;
  std::array<double, 3> scale{1, 1, 1}, shift{0, 0, 0};
  std::vector<std::byte> descriptor;  ///< one or several of 192 bytes; empty: undescribed
};

/// How a cloud will lie in a LAS file: decided before the first byte is written.
struct Plan {
  unsigned version_minor = 2;
  unsigned format = 0;
  size_t record_bytes = 0;
  std::vector<StandardColumn> standard;
  std::vector<ExtraColumn> extra;
  std::vector<Record> vlrs, evlrs;
  std::vector<std::byte> old_header;  ///< of the file that the cloud came from, or empty
  LengthUnits units;                  ///< of the coordinates in the file
  Vec3 scale, offset;                 ///< in that unit
  bool has_steps_of_bounds = false;   ///< those follow from where the points are
};

/// What a file is beyond LAS. COPC has no point format with wave packets, and names its CRS by WKT.
enum class Profile { kPlain, kCopc };

/// bounds: of all points, in metres, where the cloud is a part of them.
Plan make_plan(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task, Profile profile = Profile::kPlain,
               const std::optional<Box3>& bounds = std::nullopt);

/// Scale and offset alone, for coordinates in metres: those of the LAS file that the cloud came from where they
/// give all coordinates back, else steps of `scale_m`, or (0) of 0.0001 m or the next power of ten that fits.
Plan plan_of_steps(const Cloud& cloud, const std::string& path, double scale_m, Task& task);

// The parts of it.
/// Fields that the format's dimensions can hold exactly, angles to a float32; the others stand in
/// `left`. Angles between the steps of a dimension are rounded there and stand in both.
std::vector<StandardColumn> standard_columns(const FieldTable& fields, unsigned format,
                                             std::vector<ColumnPtr>& left, Task& task);
/// Lays the other fields out behind the core of the format's record, with the descriptors that their
/// file had where they still fit.
std::vector<ExtraColumn> extra_columns(const std::vector<ColumnPtr>& fields,
                                       const std::vector<ExtraDimension>& known, unsigned format,
                                       Task& task);

}  // namespace jalon::las
