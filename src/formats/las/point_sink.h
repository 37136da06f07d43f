// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/buffer.h"
#include "cloud/cloud.h"
#include "formats/las/fields.h"
#include "formats/las/layout.h"
#include "geometry/vec.h"

namespace jalon::las {

/// The point of a record; unit: metres in the file's.
Vec3 place_of(const Header& header, const Vec3& unit, const std::byte* record);

/// Copies one dimension of a block of records into its column.
struct Extraction {
  std::shared_ptr<Column> column;
  size_t offset = 0;
  int shift = 0, bits = 0;
  double factor = 1;
  const double* scale = nullptr;  ///< of a scaled extra dimension, one a component
  const double* move = nullptr;
  void (*run)(const Extraction&, const std::byte* records, size_t stride, size_t n,
              size_t first) = nullptr;
};

/// A cloud that is filled with records.
class PointSink {
 public:
  /// Of so many points with these fields. All live as long.
  PointSink(const Header& header, const Vec3& unit, const std::vector<Dimension>& standard,
            const std::vector<ExtraDimension>& extra, size_t count);
  const Header& header() const { return header_; }
  /// n records, of the points from `first` on. Any thread, each point once.
  void put(const std::byte* records, size_t n, size_t first);
  /// When all points are there.
  Cloud cloud();

 private:
  const Header& header_;
  Vec3 unit_;
  Buffer<double> xyz_;
  std::vector<Extraction> extractions_;
};

}  // namespace jalon::las
