// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "base/numbers.h"
#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// What of a triangle is closest to a point.
enum class TriangleFeature : uint8_t { kFace, kSide, kCorner };

/// What the surface is like at the closest point, as far as its side is concerned.
enum class TriangleSide : uint8_t {
  kCertain = 0,  ///< inside a triangle, or all around it triangles that run one way around
  kBorder = 1,   ///< at a border of the surface: the side is that of the surface as continued
  kInconsistent =
      2  ///< triangles beside each other run opposite ways around: the side of the nearest one
};

/// What is asked besides distance and triangle; either costs some time.
struct TriangleQuestions {
  bool sides = false;  ///< is_behind and side
  bool feet = false;   ///< feature, foot and from_foot
};

/// The triangle nearest to a point.
struct TriangleAnswer {
  double distance = kNaN;            ///< not negative
  uint32_t triangle = ~uint32_t{0};  ///< caller's number
  TriangleFeature feature = TriangleFeature::kFace;
  bool is_behind = false;  ///< on the side from which the surface's corners run clockwise
  TriangleSide side = TriangleSide::kCertain;
  Vec3 foot;       ///< the closest point
  Vec3 from_foot;  ///< from there to the point
};

/// Nearest triangle of a set, exact in doubles: the least distance, then the least number; triangles that share a side
/// or a corner tie exactly there. Triangles without area count as their longest side, or as a point. Immutable; any
/// number of threads may ask.
///
/// Corners are kept as doubles relative to a whole metre, so that map coordinates lose nothing and a shift by whole
/// metres changes no bit. A tree of four boxes a node with leaves of four triangles (Wald 2007), descended nearest box
/// first; the answer of one point bounds the search of the next.
///
/// Sides are told by the angle-weighted pseudo-normal at the closest point (Baerentzen & Aanaes 2005, Signed distance
/// computation using the angle weighted pseudonormal): of all triangles that touch it, each by the angle that it fills
/// there. Right everywhere about a closed surface whose triangles run one way around, also where corners of some meet
/// sides of others; at the border of an open one it is the side of the surface as continued.
class NearestTriangles {
 public:
  /// vertices and indices as of TriangleTree. kInvalidArgument names the first vertex in use that is not finite.
  static std::shared_ptr<const NearestTriangles> build(
      std::span<const Vec3> vertices, std::span<const std::array<uint32_t, 3>> triangles,
      Task& task);
  ~NearestTriangles();

  size_t size() const;
  /// How many are looked at: where more than a thousand lie on one another, up to roundings, the one of the least
  /// number stands for each such stack.
  size_t distinct() const;
  size_t memory_bytes() const;

  /// visit(item, answer) for every item of order (indices of the points: 3 doubles each), in chunks that run in
  /// parallel; neighbours in the order should be neighbours in space. Without a triangle within max_distance
  /// (inclusive) the answer has distance NaN and no triangle.
  template <class F>
  void for_each(std::span<const double> xyz, std::span<const uint32_t> order, double max_distance,
                const TriangleQuestions& questions, Task& task, F&& visit) const {
    ask(
        xyz, order, max_distance, questions, task,
        [](void* p, uint32_t item, const TriangleAnswer& answer) {
          (*static_cast<std::remove_reference_t<F>*>(p))(item, answer);
        },
        &visit);
  }
  /// The same for one point.
  TriangleAnswer nearest(const Vec3& point,
                         double max_distance = std::numeric_limits<double>::infinity(),
                         const TriangleQuestions& questions = {true, true}) const;

 private:
  using Visit = void (*)(void* context, uint32_t item, const TriangleAnswer& answer);
  NearestTriangles();
  void ask(std::span<const double> xyz, std::span<const uint32_t> order, double max_distance,
           const TriangleQuestions& questions, Task& task, Visit visit, void* context) const;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jalon
