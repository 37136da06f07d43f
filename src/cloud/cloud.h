// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "base/buffer.h"
#include "base/field.h"
#include "base/shared_text.h"
#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Where a scan was taken from, and which points it saw.
struct Station {
  SharedText name;
  bool has_pose = false;
  Transform pose;  ///< T_world_scanner
  uint64_t first = 0, count = 0;
};

/// Bytes that a file format wants back when the cloud is written again (VLRs ...); opaque to everybody else.
struct Attachment {
  std::string key;  ///< e.g. "las:vlr"
  std::vector<std::byte> bytes;
};

/// The octree of one set of points, built at most once and shared by all clouds that share the points.
class IndexSlot {
 public:
  /// The tree, built now if need be; threads that come meanwhile wait, and one of them takes over when the
  /// builder fails.
  std::shared_ptr<const Octree> get(std::span<const double> xyz, Task& task);
  /// Replaces it by a tree on this cube unless it has it already.
  std::shared_ptr<const Octree> get_on(std::span<const double> xyz, const Cube& cube, Task& task);

  /// Forgets the tree, until it is asked for again; who holds it keeps it.
  void drop();

  /// What was made of the points and may be wanted again soon. The slot does not keep it alive.
  struct Remembered {
    virtual ~Remembered() = default;
  };
  void remember(const std::shared_ptr<Remembered>& made);
  std::shared_ptr<Remembered> remembered();

 private:
  std::shared_ptr<const Octree> build(std::span<const double> xyz, const Cube* cube, Task& task);
  std::mutex mutex_;
  std::condition_variable changed_;
  bool building_ = false;
  std::shared_ptr<const Octree> tree_;
  std::weak_ptr<Remembered> remembered_;
};

/// Points + fields + stations + CRS. A value: copies share the storage; the points are never changed. Functions that
/// "change" a cloud copy it, change the copy's table, and give it back.
struct Cloud {
  std::shared_ptr<const Buffer<double>> xyz_buffer =
      std::make_shared<Buffer<double>>();  ///< 3n, caller's doubles
  FieldTable fields;
  std::vector<Station> stations;  ///< in the order of their points, which do not overlap
  SharedText crs;
  std::shared_ptr<const std::vector<Attachment>> attachments;  ///< may be null
  std::shared_ptr<IndexSlot> index = std::make_shared<IndexSlot>();

  size_t size() const { return xyz_buffer->size() / 3; }
  std::span<const double> xyz() const { return *xyz_buffer; }
  Vec3 point(size_t i) const {
    const double* p = xyz_buffer->data() + 3 * i;
    return {p[0], p[1], p[2]};
  }
  std::shared_ptr<const Octree> octree(Task& task) const { return index->get(xyz(), task); }
};

using CloudPtr = std::shared_ptr<const Cloud>;

/// A cloud of these points without fields; takes the buffer. Checks nothing.
Cloud make_cloud(Buffer<double> xyz);
/// Throws kInvalidArgument naming the first point that is not finite.
void require_finite(std::span<const double> xyz);
Box3 bounds(const Cloud& cloud, Task& task);
/// Points of these indices in this order, with fields, and stations where they stay contiguous.
Cloud select(const Cloud& cloud, std::span<const uint64_t> indices, Task& task);
Cloud append(const Cloud& a, const Cloud& b, Task& task);
Cloud transformed(const Cloud& cloud, const Transform& transform, Task& task);
/// Station pose of point i, or nullptr.
const Station* station_of(const Cloud& cloud, uint64_t i);

}  // namespace jalon
