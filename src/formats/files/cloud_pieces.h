// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/task.h"
#include "cloud/cloud.h"

// Files larger than memory: their points come and go in pieces.
namespace jalon {

/// A file of points that is read piece by piece.
class CloudPieces {
 public:
  virtual ~CloudPieces() = default;
  /// Points in the file, those of its pieces at most.
  virtual uint64_t count() const = 0;
  /// The share of all work that look_through() has.
  virtual double look_share() const { return 0; }
  /// What the pieces need to know of the whole file, before the first one; false where it must be read whole.
  virtual bool look_through(Task&) { return true; }
  /// The first piece comes again.
  virtual void rewind() = 0;
  /// The points that follow, about so many, with all that a cloud of the whole file has; false behind the last. There
  /// is one piece at least, if need be without points.
  virtual bool next(size_t most, Cloud& piece, Task& task) = 0;
};

/// A file of points that is written piece by piece; nothing is there before finish().
class CloudSink {
 public:
  virtual ~CloudSink() = default;
  /// Whether the file must know where all points are before the first piece, which this is, can be put.
  virtual bool asks_for_bounds(const Cloud&, Task&) const { return false; }
  virtual void tell_bounds(const Box3&) {}
  /// False where this piece would change what the pieces before it have settled (steps, types, names): only a cloud of
  /// all points can be written then.
  virtual bool put(const Cloud& piece, Task& task) = 0;
  virtual void finish(Task& task) = 0;
};

}  // namespace jalon
