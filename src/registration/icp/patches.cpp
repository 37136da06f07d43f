// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/rigid_motion.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

// Points of the reference that are cut into patches together: a patch of a wall has as many.
constexpr size_t kPatchesRun = 192;
constexpr size_t kRunsPerChunk = 32;
constexpr size_t kPatchesGrain = 1 << 14;
constexpr size_t kPatchesBetweenReports = 1 << 18;  // points: a few milliseconds
constexpr size_t kMostSeeds = 32;                   // in a run: what is left are stray points
// A point belongs to the patch of another where both their planes, in the mean, lead from one to the other within so
// many noises, and a share of the distance for the noise of their normals and the bend of the surface.
constexpr double kNearNoises = 5, kNearSlope = 0.03;
constexpr double kAlike = 0.75;  // cosine between the normals
constexpr size_t kLeastFlat = 6;
// A plane through many points tells which others lie on it better than the normals of these do.
constexpr double kFlatNoises = 1.4, kOnPlaneNoises = 4, kAlikeOnPlane = 0.5;
constexpr double kPatchesLeastAspect = 0.02;  // of the squared extents
constexpr double kBeyond = 3;                 // root mean squares of the points along either axis

// Where a wall lies along the sides of the tree's cells, as walls at whole metres do, the noise of its points tells on
// which side they are, and a shift is not seen any more. Cells that are turned like this lie along nothing that is
// built.
constexpr Vec3 kTurn_rad{0.53, 0.71, 0.97};

// Positions of the reference's points, near ones together.
std::vector<uint32_t> turned_order(const SurfacePlanes& reference, Task& task) {
  const Transform turned = motion_about({}, kTurn_rad, {});
  Buffer<double> xyz(3 * reference.size());
  const Box3 box =
      parallel_reduce(task, reference.size(), kPatchesGrain, Box3{}, [&](size_t begin, size_t end) {
        Box3 part;
        for (size_t i = begin; i < end; ++i) {
          const Vec3 p = turned.point(reference.place(i));
          for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = p[c];
          part.add(p);
        }
        return part;
      });
  const auto tree = Octree::build(xyz, enclosing_cube(box), task);
  const auto order = tree->order();
  return {order.begin(), order.end()};
}

/// A point of a run, in the reference frame.
struct Candidate {
  Vec3 place, normal;
  float height_m = 0, sigma_m = 0;
  bool moving = false, taken = false;
};

/// One run's points, their patches and the memory for them.
class Run {
 public:
  Run(double noise_m, const RobustKernel& kernel, const IcpFrame& frame)
      : noise_m_(noise_m), kernel_(kernel), frame_(frame) {}
  void clear() { all_.clear(); }
  void add(const Vec3& place, const Vec3& normal, const SurfacePlane& plane, bool moving) {
    all_.push_back({place, normal, plane.height_m, plane.sigma_m, moving, false});
  }
  void add_patches(PatchSums& sums) {
    order_.resize(all_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](uint32_t a, uint32_t b) { return all_[a].sigma_m < all_[b].sigma_m; });
    size_t seeds = 0;
    for (const uint32_t seed : order_) {
      if (all_[seed].taken) continue;
      if (seeds++ == kMostSeeds) break;
      add_patch_of(seed, sums);
    }
  }

 private:
  // Step 1: the points that the plane of the seed and their own lead to.
  void collect(const Candidate& seed, Vec3& normal) {
    members_.clear();
    normal = {};
    const Vec3 foot = seed.place + seed.normal * double{seed.height_m};
    for (uint32_t i = 0; i < all_.size(); ++i) {
      const Candidate& c = all_[i];
      if (c.taken) continue;
      const double cosine = dot(c.normal, seed.normal);
      if (std::abs(cosine) < kAlike) continue;
      const Vec3 other = cosine < 0 ? -c.normal : c.normal, d = c.place - foot;
      if (std::abs(dot(seed.normal + other, d)) >
          2 * (kNearNoises * noise_m_ + kNearSlope * norm(d)))
        continue;
      members_.push_back(i);
      normal += other;
    }
  }
  // Step 2: where these lie on a plane, all that lie on it.
  void extend(Vec3& normal) {
    if (members_.size() < kLeastFlat) return;
    Vec3 centre;
    for (const uint32_t i : members_) centre += all_[i].place;
    const auto count = static_cast<double>(members_.size());
    centre = centre / count;
    Symmetric3 scatter{};
    for (const uint32_t i : members_) {
      const Vec3 d = all_[i].place - centre;
      const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
      for (size_t c = 0; c < 6; ++c) scatter[c] += row[c];
    }
    const Eigen3 e = symmetric_eigen(scatter);
    const double flat_m = kFlatNoises * noise_m_;
    if (e.values[0] > count * flat_m * flat_m || !(e.values[1] > kPatchesLeastAspect * e.values[2]))
      return;
    const double along = kBeyond * kBeyond * e.values[2] / count,
                 across = kBeyond * kBeyond * e.values[1] / count;
    members_.clear();
    for (uint32_t i = 0; i < all_.size(); ++i) {
      const Candidate& c = all_[i];
      if (c.taken || std::abs(dot(c.normal, e.vectors[0])) < kAlikeOnPlane) continue;
      const Vec3 d = c.place - centre;
      const double u = dot(e.vectors[2], d), v = dot(e.vectors[1], d);
      if (std::abs(dot(e.vectors[0], d)) <= kOnPlaneNoises * noise_m_ && u * u <= along &&
          v * v <= across)
        members_.push_back(i);
    }
    normal = e.vectors[0];
  }
  void add_patch_of(uint32_t seed, PatchSums& sums) {
    Vec3 normal;
    collect(all_[seed], normal);
    extend(normal);
    const uint64_t before = sums.patches;
    points_.clear();
    for (const uint32_t i : members_) points_.push_back({all_[i].place, all_[i].moving});
    add_patch(points_, normalized(normal), noise_m_, kernel_, frame_, sums);
    // Points of no patch may yet lie on a larger one.
    if (sums.patches > before)
      for (const uint32_t i : members_) all_[i].taken = true;
    all_[seed].taken = true;
  }

  double noise_m_;
  const RobustKernel& kernel_;
  const IcpFrame& frame_;
  std::vector<Candidate> all_;
  std::vector<uint32_t> order_, members_;
  std::vector<PatchPoint> points_;
};

}  // namespace

IcpPatches::IcpPatches(const IcpClouds& clouds, const IcpNeighbours& neighbours, Task& task)
    : clouds_(clouds),
      noise_m_(std::sqrt(0.5 * (clouds.reference.noise_m * clouds.reference.noise_m +
                                clouds.moving.noise_m * clouds.moving.noise_m))),
      order_(turned_order(clouds.reference, task)) {
  const Buffer<uint32_t>& partner = neighbours.of_moving;
  const auto has_say = [&](size_t i) { return partner[i] != kNoPoint && clouds.moving.flat(i); };
  first_.assign(clouds.reference.size() + 1, 0);
  for (size_t i = 0; i < partner.size(); ++i) {
    if (i % kPatchesBetweenReports == 0) task.checkpoint(1);
    if (has_say(i)) ++first_[partner[i] + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  moving_.resize(first_.back());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (size_t i = 0; i < partner.size(); ++i) {
    if (i % kPatchesBetweenReports == 0) task.checkpoint(1);
    if (has_say(i)) moving_[next[partner[i]]++] = static_cast<uint32_t>(i);
  }
}

PatchSums IcpPatches::sums(const Transform& T_reference_moving, const RobustKernel& kernel,
                           const IcpFrame& frame, Task& task) const {
  const SurfacePlanes &reference = clouds_.reference, &moving = clouds_.moving;
  const size_t runs = (reference.size() + kPatchesRun - 1) / kPatchesRun;
  return parallel_reduce(task, runs, kRunsPerChunk, PatchSums{}, [&](size_t begin, size_t end) {
    PatchSums part;
    Run run(noise_m_, kernel, frame);
    for (size_t r = begin; r < end; ++r) {
      const size_t first = r * kPatchesRun, last = std::min(first + kPatchesRun, reference.size());
      run.clear();
      for (size_t at = first; at < last; ++at) {
        const uint32_t i = order_[at];
        const SurfacePlane& plane = reference.planes[i];
        if (reference.flat(i)) run.add(reference.place(i), plane.unit(), plane, false);
        for (uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
          const uint32_t m = moving_[k];
          const SurfacePlane& moved = moving.planes[m];
          run.add(T_reference_moving.point(moving.place(m)),
                  T_reference_moving.direction(moved.unit()), moved, true);
        }
      }
      run.add_patches(part);
    }
    return part;
  });
}

}  // namespace jalon
