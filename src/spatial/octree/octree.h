// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Cube of an octree: cells of level l have the edge edge / 2^l. edge is a power of two and the origin a multiple of a
/// whole metre (of edge / 2^31 for smaller clouds), so that shifting a cloud by whole metres shifts the cube and
/// changes no code.
struct Cube {
  Vec3 origin;
  double edge = 1;
  bool operator==(const Cube&) const = default;
};

/// The smallest cube of that kind around a box (with room for the upper faces).
Cube enclosing_cube(const Box3& box);

constexpr int kMaxLevel = 21;
constexpr uint32_t kNoPoint = 0xffffffffu;

/// One neighbour; order: squared distance, then index.
struct Neighbour {
  double squared_distance;
  uint32_t index;  ///< in the caller's order
};

/// Linear octree: points sorted by Morton code (Girardeau-Montaut 2006, chapter 4). Immutable; any number of threads
/// may query it.
///
/// It keeps 31-bit fixed-point coordinates in the cube (12 B a point), the order (4 B) and small nodes (about 3 B); it
/// does not own the doubles, which must outlive it and are read to settle near-ties, so that answers equal brute force
/// in doubles exactly.
class Octree {
 public:
  /// xyz: 3n doubles, finite. Throws kLimit above 2^32 - 2 points. Parallel; the same bits for any number of threads.
  static std::shared_ptr<const Octree> build(std::span<const double> xyz, const Cube& cube,
                                             Task& task);
  ~Octree();

  size_t size() const;
  const Cube& cube() const;
  std::span<const uint32_t> order() const;      ///< sorted position -> caller's index
  uint64_t code(size_t sorted_position) const;  ///< 63-bit Morton code at level 21
  size_t memory_bytes() const;

  struct Cell {
    uint64_t code;        ///< 3 * level bits
    size_t first, count;  ///< in sorted positions
  };
  /// Occupied cells of a level, in code order.
  std::vector<Cell> cells(int level, Task& task) const;
  /// Numbers of occupied cells at levels 0 ... 21 (2.1 step 5).
  std::vector<uint64_t> cell_counts(Task& task) const;
  /// The points of one cell: an empty range (count 0) when it is not occupied.
  Cell cell(int level, uint64_t code) const;
  /// Codes of occupied cells at Chebyshev distance 1..reach, ascending.
  std::vector<uint64_t> neighbour_cells(int level, uint64_t code, uint32_t reach) const;

  /// The min(k, size) nearest points of q, nearest first, ties by index. Adaptive search. out has room for k.
  size_t knn(const Vec3& q, uint32_t k, std::span<Neighbour> out) const;
  /// The nearest point, of equally near ones that of the smallest index; false when none lies within the radius.
  /// Queries far from all points cost little.
  bool nearest_within(const Vec3& q, double radius, Neighbour& out) const;
  /// The points in the closed ball, in ascending index order.
  void radius(const Vec3& q, double radius, std::vector<Neighbour>& out) const;
  /// The same two with sorted positions in the place of the caller's indices; those of the ball ascend.
  size_t knn_positions(const Vec3& q, uint32_t k, std::span<Neighbour> out) const;
  void radius_positions(const Vec3& q, double radius, std::vector<Neighbour>& out) const;

  /// For every point in sorted order its k nearest (itself included) by the fast batch path: visit(chunk, Batch),
  /// chunks of consecutive sorted positions, in parallel. k <= 256. Fewer than k points in the tree: kNoPoint fills up.
  struct Batch {
    size_t first, count;         ///< sorted positions [first, first + count)
    const uint32_t* neighbours;  ///< count * k sorted positions (not caller's indices)
    const float* squared;        ///< count * k squared distances, m^2
    uint32_t k;
  };
  template <class F>
  void for_each_knn(uint32_t k, Task& task, F&& visit) const {
    knn_batches(
        k, task, [](void* p, const Batch& b) { (*static_cast<std::remove_reference_t<F>*>(p))(b); },
        &visit);
  }
  /// The same for all points within radius of each point (itself included).
  struct BallBatch {
    size_t first, count;
    const uint32_t* offsets;     ///< count + 1
    const uint32_t* neighbours;  ///< sorted positions
    const float* squared;
  };
  template <class F>
  void for_each_ball(double radius, Task& task, F&& visit) const {
    ball_batches(
        radius, task,
        {[](void* p, const BallBatch& b) { (*static_cast<std::remove_reference_t<F>*>(p))(b); },
         &visit, nullptr, nullptr, nullptr, nullptr});
  }
  /// Do very many points share a place of the grid, or crowd below its step? Then balls may hold most of the cloud
  /// about most of its points, and all pairs are too many. O(1).
  bool has_crowds() const;
  /// The end of the points from this sorted position on that share its place of the grid and follow one another.
  size_t end_of_place(size_t first) const;
  /// Points on one place of the grid that follow one another in the tree's order.
  struct PlaceGroup {
    uint32_t first, last;  ///< sorted positions [first, last)
    float squared;         ///< squared distance of the place, m^2
  };
  struct CrowdedBall {
    size_t point;                        ///< sorted position
    std::span<const PlaceGroup> groups;  ///< ascending
  };
  /// for_each_ball for a tree that has crowds: of a ball that holds very many points crowded(CrowdedBall) is called in
  /// the place of visit. Its groups are as many as its places, and in a crowd there are few.
  template <class F, class G>
  void for_each_crowded_ball(double radius, Task& task, F&& visit, G&& crowded) const {
    ball_batches(
        radius, task,
        {[](void* p, const BallBatch& b) { (*static_cast<std::remove_reference_t<F>*>(p))(b); },
         &visit,
         [](void* p, const CrowdedBall& b) { (*static_cast<std::remove_reference_t<G>*>(p))(b); },
         &crowded, nullptr, nullptr});
  }
  /// Sorted positions [first, last).
  struct PointRange {
    uint32_t first, last;
  };
  struct RangedBall {
    size_t point;                        ///< sorted position
    std::span<const PointRange> ranges;  ///< ascending, as few as there are
    size_t count;                        ///< of their points
  };
  /// for_each_ball where sums over ranges suffice (RangeSums): of a ball that holds more than some thousand points
  /// ranged(RangedBall) is called in the place of visit. Its ranges cost what the surface of the ball cuts.
  template <class F, class G>
  void for_each_ranged_ball(double radius, Task& task, F&& visit, G&& ranged) const {
    ball_batches(
        radius, task,
        {[](void* p, const BallBatch& b) { (*static_cast<std::remove_reference_t<F>*>(p))(b); },
         &visit, nullptr, nullptr,
         [](void* p, const RangedBall& b) { (*static_cast<std::remove_reference_t<G>*>(p))(b); },
         &ranged});
  }
  /// Coordinates of a sorted position relative to the cube's origin, in metres, from the 31-bit grid (rounded down,
  /// error < edge / 2^31): enough for normals and features, and the same bits wherever the cloud lies.
  Vec3 local(size_t sorted_position) const;
  /// Raw fixed-point coordinates and their step (m).
  const int32_t* grid_x() const;
  const int32_t* grid_y() const;
  const int32_t* grid_z() const;
  double grid_step() const;

  struct Impl;
  const Impl& impl() const { return *impl_; }  ///< for the files of this room (octree_impl.h)

 private:
  Octree();
  void knn_batches(uint32_t k, Task& task, void (*visit)(void*, const Batch&), void* context) const;
  // Of crowded and ranged one at most.
  struct BallVisitors {
    void (*visit)(void*, const BallBatch&);
    void* context;
    void (*crowded)(void*, const CrowdedBall&);
    void* crowded_context;
    void (*ranged)(void*, const RangedBall&);
    void* ranged_context;
  };
  void ball_batches(double radius, Task& task, const BallVisitors& visitors) const;
  std::unique_ptr<Impl> impl_;
};

/// Constant-level k nearest neighbours (2.3, formula 4.1), cell-batched: queries are grouped by their cell, and each
/// group shares the points gathered around it. Queries may lie anywhere, in any order; the level (1 ... 21) changes the
/// time, never the answer, which is that of Octree::knn. out: queries * k, filled up with kNoPoint at infinity.
void knn_at_level(const Octree& reference, std::span<const Vec3> queries, uint32_t k, int level,
                  Task& task, std::span<Neighbour> out);
/// Formula 4.2: the level expected to be fastest for k neighbours in reference of all points of compared. Both on one
/// cube.
int best_level(const Octree& reference, const Octree& compared, uint32_t k, Task& task);

}  // namespace jalon
