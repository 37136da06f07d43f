// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/influence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "registration/surface/plane_points.h"

namespace jalon {

namespace {

constexpr size_t kExact = 100'000;  // points of a cloud
constexpr size_t kInfluenceRun =
    16;  // points of a run in the tree's order: those of a plane, or nearly
constexpr size_t kMostInfluences = size_t{1}
                                   << 17;  // points looked at; of more, every second, third ... run
constexpr size_t kInfluenceBetweenReports = 1 << 15;  // pairs or points: some milliseconds
constexpr double kOneFace = 0.7;  // cosine between the normals of points on one face

/// Six numbers of one point.
struct Share {
  float of[6] = {};
  void add(const Coefficients<6>& j, double factor) {
    for (size_t i = 0; i < 6; ++i) of[i] += static_cast<float>(factor * j[i]);
  }
};

/// A quarter of the work: how much of it is done.
struct Progress {
  Task& task;
  double from;
  void operator()(size_t done, size_t all) const {
    task.checkpoint(from + 0.25 * static_cast<double>(done) / static_cast<double>(all));
  }
};

/// What one cloud's points put into the right-hand side: each through its own pair, and through its plane.
class CloudInfluence {
 public:
  CloudInfluence(const SurfacePlanes& planes, bool exact)
      : planes_(planes),
        stride_(exact ? 1 : (planes.size() + kMostInfluences - 1) / kMostInfluences),
        exact_(exact),
        own_(slots()),
        plane_(slots()),
        tilt_(exact ? slots() : 0) {}

  bool looks_at(uint32_t position) const { return slot(position) != kUnused; }

  // factor: the sign of the cloud in the residual, and of the pair's normal against that of the point.
  void add_point(uint32_t position, const Coefficients<6>& j, double factor) {
    if (const size_t s = slot(position); s != kUnused) own_[s].add(j, factor);
  }
  // offset: the pair's place from the plane's point.
  void add_plane(uint32_t position, const Coefficients<6>& j, double factor, const Vec3& offset) {
    const size_t s = slot(position);
    if (s == kUnused) return;
    plane_[s].add(j, factor);
    if (!exact_) return;
    for (int axis = 0; axis < 3; ++axis)
      tilt_[s][static_cast<size_t>(axis)].add(j, factor * offset[axis]);
  }

  Square<6> squares(uint32_t k, const Progress& report) {
    const size_t step = exact_ ? 1 : kInfluenceRun * stride_;
    for (size_t first = 0, done = 0; first < planes_.size(); first += step, ++done) {
      if (done % (kInfluenceBetweenReports / kInfluenceRun) == 0) report(first, planes_.size());
      if (exact_) share_exactly(static_cast<uint32_t>(first), k);
      else share_in_run(first);
    }
    Square<6> out{};
    for (size_t first = 0; first < planes_.size(); first += kInfluenceRun * stride_)
      for (size_t i = first; i < std::min(first + kInfluenceRun, planes_.size()); ++i)
        add_square(i, out);
    for (double& v : out) v *= static_cast<double>(stride_);
    return out;
  }

 private:
  static constexpr size_t kUnused = SIZE_MAX;
  using Tilt = std::array<Share, 3>;

  size_t slots() const { return (planes_.size() / (kInfluenceRun * stride_) + 1) * kInfluenceRun; }
  size_t slot(size_t position) const {
    const size_t run = position / kInfluenceRun;
    return run % stride_ == 0 ? run / stride_ * kInfluenceRun + position % kInfluenceRun : kUnused;
  }
  // +1 or -1: which way the normal of b points against that of a; 0: on different faces.
  double alike(size_t a, size_t b) const {
    if (a == b) return 1;
    const double cosine = dot(planes_.planes[a].unit(), planes_.planes[b].unit());
    return std::abs(cosine) < kOneFace ? 0 : cosine > 0 ? 1 : -1;
  }

  void share_exactly(uint32_t position, uint32_t k) {
    const Share& mean = plane_[position];
    if (std::all_of(mean.of, mean.of + 6, [](float v) { return v == 0; })) return;
    for (const PlaneShare& share : plane_shares(planes_, position, k)) {
      const double cosine =
          dot(planes_.planes[position].unit(), planes_.planes[share.position].unit());
      const double sign = cosine < 0 ? -1 : 1;
      for (size_t i = 0; i < 6; ++i) {
        const double along = tilt_[position][0].of[i] * share.slope.x +
                             tilt_[position][1].of[i] * share.slope.y +
                             tilt_[position][2].of[i] * share.slope.z;
        own_[share.position].of[i] +=
            static_cast<float>(sign * (mean.of[i] * share.height + along));
      }
    }
  }

  void share_in_run(size_t first) {
    const size_t end = std::min(first + kInfluenceRun, planes_.size());
    for (size_t p = first; p < end; ++p) {
      double signs[kInfluenceRun] = {}, count = 0;
      for (size_t m = first; m < end; ++m) {
        signs[m - first] = alike(p, m);
        count += std::abs(signs[m - first]);
      }
      const Share& mean = plane_[slot(p)];
      for (size_t m = first; m < end; ++m)
        for (size_t i = 0; i < 6; ++i)
          own_[slot(m)].of[i] += static_cast<float>(signs[m - first] * double{mean.of[i]} / count);
    }
  }

  void add_square(size_t position, Square<6>& out) const {
    const float* b = own_[slot(position)].of;
    const double sigma =
        planes_.flat(position) ? planes_.planes[position].sigma_m : planes_.noise_m;
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < 6; ++c) out[6 * r + c] += sigma * sigma * b[r] * b[c];
  }

  const SurfacePlanes& planes_;
  size_t stride_;
  bool exact_;
  std::vector<Share> own_, plane_;
  std::vector<Tilt> tilt_;
};

Coefficients<6> coefficients_of(const IcpPair& pair, const IcpFrame& frame) {
  const Vec3 turn = cross((pair.place - frame.centre) / frame.extent_m, pair.normal);
  return {turn.x, turn.y, turn.z, pair.normal.x, pair.normal.y, pair.normal.z};
}

}  // namespace

Square<6> icp_influence(const IcpPairing& at, const IcpFrame& frame, uint32_t k, Task& task) {
  const SurfacePlanes &of_reference = at.clouds.reference, &of_moving = at.clouds.moving;
  const bool exact = std::max(of_reference.size(), of_moving.size()) <= kExact;
  CloudInfluence reference(of_reference, exact), moving(of_moving, exact);
  const Transform T_moving_reference = inverse(at.T_reference_moving);
  const Progress forth{task, 0}, back{task, 0.25};
  const auto faces = [](const Vec3& n, const Vec3& own) { return dot(n, own) < 0 ? -1.0 : 1.0; };
  IcpPair pair;
  // 1. Raw moving points on planes of the reference: the residual grows with the point along its
  // own normal, and falls with the plane.
  const Buffer<uint32_t>& partners = at.neighbours.of_moving;
  for (size_t i = 0; i < partners.size(); ++i) {
    const uint32_t m = static_cast<uint32_t>(i), r = partners[i];
    if (i % kInfluenceBetweenReports == 0) forth(i, partners.size());
    if (r == kNoPoint || !(moving.looks_at(m) || reference.looks_at(r))) continue;
    if (!pair_of(at, m, r, PairWay::kForth, pair)) continue;
    const Coefficients<6> j = coefficients_of(pair, frame);
    const Vec3 own = at.T_reference_moving.direction(of_moving.planes[m].unit());
    moving.add_point(m, j, faces(pair.normal, own));
    reference.add_plane(r, j, -1, pair.place - of_reference.place(r));
  }
  // 2. Raw reference points under planes of the moving cloud: the other way round.
  const Buffer<uint32_t>& partners_back = at.neighbours.of_reference;
  for (size_t i = 0; i < partners_back.size(); ++i) {
    const uint32_t r = static_cast<uint32_t>(i), m = partners_back[i];
    if (i % kInfluenceBetweenReports == 0) back(i, partners_back.size());
    if (m == kNoPoint || !(moving.looks_at(m) || reference.looks_at(r))) continue;
    if (!pair_of(at, m, r, PairWay::kBack, pair)) continue;
    const Coefficients<6> j = coefficients_of(pair, frame);
    reference.add_point(r, j, -faces(pair.normal, of_reference.planes[r].unit()));
    moving.add_plane(m, j, 1, T_moving_reference.point(of_reference.place(r)) - of_moving.place(m));
  }
  // 3. Squares of what each point put in, times its variance.
  Square<6> out = reference.squares(k, {task, 0.5});
  const Square<6> squares_moving = moving.squares(k, {task, 0.75});
  for (size_t i = 0; i < out.size(); ++i) out[i] += squares_moving[i];
  return out;
}

}  // namespace jalon
