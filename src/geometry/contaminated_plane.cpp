// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contaminated_plane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "geometry/contamination_state.h"

namespace jalon {

namespace {

constexpr size_t kContaminatedPlanePointsPerChunk = 1 << 14;
constexpr size_t kLeastPoints = 20;     // twice the unknowns and more
constexpr size_t kLeastZonePoints = 8;  // fewer are counted with the other zone
constexpr size_t kMostForTwoStarts =
    20000;                       // among more, contamination cannot lead least squares astray
constexpr size_t kFew = 20000;   // samples that say where the others' steps will lead
constexpr size_t kFewOfAll = 4;  // and how many times as many there must be
constexpr int kIterations = 40;
constexpr double kLeastSigma = 0.04;  // of the tolerance: below it nothing needs telling apart
constexpr double kStartShare = 0.03;
constexpr double kLeastShare = 0.002;   // less, or less than two points, is none
constexpr double kHaste = 1.8;          // exponent of the shares' steps: plain ones creep toward 0
constexpr double kStableSteps2 = 1e-4;  // squared standard errors
constexpr double kStableShare = 1e-3;
constexpr double kLeastCore = 0.3;  // share of the plane's own points
constexpr double kLeastKept =
    0.3;  // of the variance of a normal distribution that the tolerance cuts

struct StepSums {
  std::array<double, 6> normal{};  ///< of height, slope_u, slope_v with the core's weights
  std::array<double, 3> right{};
  double squares = 0;
  std::array<double, kContaminationZones> front{}, behind{}, count{};

  double core() const { return normal[0]; }
  StepSums& operator+=(const StepSums& b) {
    for (size_t i = 0; i < 6; ++i) normal[i] += b.normal[i];
    for (size_t i = 0; i < 3; ++i) right[i] += b.right[i];
    squares += b.squares;
    for (size_t z = 0; z < kContaminationZones; ++z)
      front[z] += b.front[z], behind[z] += b.behind[z], count[z] += b.count[z];
    return *this;
  }
};

/// Adds up the points of a chunk, four sums at a time.
class StepAdder {
 public:
  void add(const PlaneSample& s, double r, const ContaminationTable::Between& at) {
    const auto u = static_cast<double>(s.u), v = static_cast<double>(s.v);
    Four a, b;
    std::memcpy(&a, at.first, sizeof a);
    std::memcpy(&b, at.first + 1, sizeof b);
    const Four weights = a + at.after * (b - a), by_u = weights * u, by_v = weights * v;
    all_ += weights, all_by_u_ += by_u, all_by_v_ += by_v;
    squares_ += Four{by_u[kCore], by_u[kCore], by_v[kCore], weights[kCore] * r} * Four{u, v, v, r};
    zone_[s.zone] += weights;
    count_[s.zone] += 1;
  }
  StepSums sums() const {
    StepSums out;
    out.normal = {all_[kCore],   all_by_u_[kCore], all_by_v_[kCore],
                  squares_[kUU], squares_[kUV],    squares_[kVV]};
    out.right = {-all_[kSlope], -all_by_u_[kSlope], -all_by_v_[kSlope]};
    out.squares = squares_[kRR];
    for (size_t z = 0; z < kContaminationZones; ++z) {
      out.front[z] = zone_[z][kFront], out.behind[z] = zone_[z][kBehind];
      out.count[z] = static_cast<double>(count_[z]);
    }
    return out;
  }

 private:
  using Four = double __attribute__((vector_size(32)));
  enum { kCore, kFront, kBehind, kSlope };  // as ContaminationTable::Weights has them
  enum { kUU, kUV, kVV, kRR };              // products, with the core's weight
  static_assert(sizeof(Four) == sizeof(ContaminationTable::Weights));
  Four all_{}, all_by_u_{}, all_by_v_{}, squares_{};
  std::array<Four, kContaminationZones> zone_{};
  std::array<uint64_t, kContaminationZones> count_{};
};

/// Expectation and maximization from a start to a maximum of the likelihood.
class Settling {
 public:
  Settling(const std::vector<PlaneSample>& samples, double tolerance_m, double sigma_m, Task& task)
      : samples_(samples), tolerance_m_(tolerance_m), task_(task) {
    state_.sigma_m = bounded_sigma(sigma_m);
    state_.front.fill(kStartShare);
    state_.behind.fill(kStartShare);
  }

  /// Moves the start to where the steps lead among every so many-th sample, which are soon gone through.
  void start_among_few() {
    std::vector<PlaneSample> few;
    const size_t step = samples_.size() / kFew;
    for (size_t i = 0; i < samples_.size(); i += step) few.push_back(samples_[i]);
    Settling among_few(few, tolerance_m_, state_.sigma_m, task_);
    if (among_few.iterate()) state_ = among_few.state_;
  }

  /// Moves the start to the least-squares plane of the points away from the border.
  bool start_inside() {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double n = 0, squares = 0;
    for (const PlaneSample& s : samples_) {
      if (s.zone == 0) continue;
      const Eigen::Vector3d g(1, static_cast<double>(s.u), static_cast<double>(s.v));
      normal += g * g.transpose();
      right += static_cast<double>(s.d) * g;
      n += 1;
    }
    if (n < static_cast<double>(kLeastZonePoints)) return false;
    if (!move(normal.ldlt().solve(right))) return false;
    for (const PlaneSample& s : samples_)
      if (s.zone != 0) squares += state_.residual(s) * state_.residual(s);
    state_.sigma_m = bounded_sigma(std::sqrt(squares / (n - 3)));
    return true;
  }

  /// False when too few points turn out to be the plane's own.
  bool run() {
    if (!iterate()) return false;
    drop_small_shares();
    if (is_clean()) state_.height = state_.slope_u = state_.slope_v = 0;
    return std::fabs(state_.height) < tolerance_m_;
  }

  const ContaminationState& state() const { return state_; }
  double log_likelihood() const {
    const std::vector<ContaminationTable> tables =
        state_.tables(tolerance_m_, ContaminationTable::With::kLogDensity);
    struct Sum {
      double value = 0;
      Sum& operator+=(const Sum& b) {
        value += b.value;
        return *this;
      }
    };
    return parallel_reduce(
               task_, samples_.size(), kContaminatedPlanePointsPerChunk, Sum{},
               [&](size_t begin, size_t end) {
                 Sum part;
                 for (size_t i = begin; i < end; ++i)
                   part.value += tables[samples_[i].zone].log_density(state_.residual(samples_[i]));
                 return part;
               })
        .value;
  }

 private:
  double bounded_sigma(double sigma_m) const {
    return std::clamp(sigma_m, kLeastSigma * tolerance_m_, tolerance_m_);
  }

  bool iterate() {
    bool stable = false;
    for (int i = 0; i < kIterations && !stable; ++i) {
      const StepSums sums = sum();
      if (!(sums.core() >= kLeastCore * static_cast<double>(samples_.size())) ||
          !step(sums, stable))
        return false;
    }
    return true;
  }

  bool move(const Eigen::Vector3d& change) {
    if (!change.allFinite()) return false;
    state_.height += change[0], state_.slope_u += change[1], state_.slope_v += change[2];
    return true;
  }

  StepSums sum() const {
    const std::vector<ContaminationTable> tables = state_.tables(tolerance_m_);
    return parallel_reduce(task_, samples_.size(), kContaminatedPlanePointsPerChunk, StepSums{},
                           [&](size_t begin, size_t end) {
                             StepAdder part;
                             for (size_t i = begin; i < end; ++i) {
                               const double r = state_.residual(samples_[i]);
                               part.add(samples_[i], r, tables[samples_[i].zone].between(r));
                             }
                             return part.sums();
                           });
  }

  // The plane by one step of scoring with the core's information, sigma and shares by their expectations.
  bool step(const StepSums& sums, bool& stable) {
    const auto& m = sums.normal;
    Eigen::Matrix3d normal;
    normal << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    const double squared = state_.sigma_m * state_.sigma_m;
    const Eigen::Vector3d right(sums.right[0], sums.right[1], sums.right[2]);
    const Eigen::Vector3d change = squared * normal.ldlt().solve(right);
    if (!move(change)) return false;
    stable = change.dot(normal * change) / squared < kStableSteps2;
    const double kept = std::max(kLeastKept, 1 - lost_by_truncation(tolerance_m_, state_.sigma_m));
    state_.sigma_m = bounded_sigma(std::sqrt(sums.squares / sums.core() / kept));
    for (size_t z = 0; z < kContaminationZones; ++z) {
      if (sums.count[z] == 0) continue;
      stable = advance(state_.front[z], sums.front[z] / sums.count[z]) && stable;
      stable = advance(state_.behind[z], sums.behind[z] / sums.count[z]) && stable;
      const double most = 1 - kLeastCore / 2,
                   scale = most / std::max(most, state_.front[z] + state_.behind[z]);
      state_.front[z] *= scale;
      state_.behind[z] *= scale;
    }
    return true;
  }

  static bool advance(double& share, double next) {
    const double before = share;
    if (share > 0) share *= std::pow(next / share, kHaste);
    return std::fabs(share - before) < kStableShare;
  }

  /// All points are the plane's own: then the start, least squares, is the maximum.
  bool is_clean() const {
    return state_.front == std::array<double, kContaminationZones>{} &&
           state_.behind == state_.front;
  }

  void drop_small_shares() {
    std::array<double, kContaminationZones> count{};
    for (const PlaneSample& s : samples_) count[s.zone] += 1;
    for (size_t z = 0; z < kContaminationZones; ++z)
      for (double* share : {&state_.front[z], &state_.behind[z]})
        if (*share * count[z] < std::max(kLeastShare * count[z], 2.0)) *share = 0;
  }

  const std::vector<PlaneSample>& samples_;
  double tolerance_m_;
  Task& task_;
  ContaminationState state_;
};

// Too few points of a zone say nothing of its shares.
void join_small_zones(std::vector<PlaneSample>& samples) {
  size_t inner = 0;
  for (const PlaneSample& s : samples) inner += s.zone;
  if (std::min(inner, samples.size() - inner) >= kLeastZonePoints) return;
  for (PlaneSample& s : samples) s.zone = 0;
}

void apply(const ContaminationState& s, const Symmetric3& covariance, PlaneFit& fit) {
  const Vec3 normal =
      normalized(fit.plane.normal - s.slope_u * fit.axis_u - s.slope_v * fit.axis_v);
  fit.centroid += s.height * fit.plane.normal;
  fit.plane = {normal, dot(normal, fit.centroid)};
  fit.axis_u = normalized(fit.axis_u - dot(fit.axis_u, normal) * normal);
  fit.axis_v = cross(normal, fit.axis_u);
  fit.local_covariance = covariance;
  update_covariance(fit);
}

}  // namespace

bool settle_contaminated_plane(std::vector<PlaneSample>& samples, double tolerance_m, Task& task,
                               PlaneFit& fit) {
  if (samples.size() < kLeastPoints || !(fit.sigma > kLeastSigma * tolerance_m)) return false;
  join_small_zones(samples);
  // 1. From least squares; and, where that may have been led astray, from the points away from the border.
  Settling from_all(samples, tolerance_m, fit.sigma, task);
  Settling from_inside = from_all;
  if (samples.size() >= kFewOfAll * kFew) from_all.start_among_few();
  const Settling* best = from_all.run() ? &from_all : nullptr;
  // 2. The likelier of the two.
  if (samples.size() <= kMostForTwoStarts && from_inside.start_inside() && from_inside.run() &&
      (best == nullptr || from_inside.log_likelihood() > best->log_likelihood()))
    best = &from_inside;
  // 3. Its covariance.
  Symmetric3 covariance;
  if (best == nullptr ||
      !contamination_covariance(samples, best->state(), tolerance_m, task, covariance))
    return false;
  apply(best->state(), covariance, fit);
  return true;
}

}  // namespace jalon
