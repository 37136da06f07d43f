// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contamination_state.h"

#include <Eigen/Dense>
#include <array>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kContaminationStatePointsPerChunk = 1 << 13;
constexpr size_t kMostForJackknife =
    1000;  // an 8 x 8 solution a point; leverages are below 1 % beyond
constexpr double kLeastCondition = 1e-14;

// In this order: height, slope_u, slope_v, ln sigma, front and behind of zone 0, of zone 1.
constexpr int kContaminationStateUnknowns = 8;
using Mat8 = Eigen::Matrix<double, kContaminationStateUnknowns, kContaminationStateUnknowns>;
using Vec8 = Eigen::Matrix<double, kContaminationStateUnknowns, 1>;

/// What a point tells: the gradient of the log likelihood and minus its second derivatives.
struct PointInformation {
  Vec8 score = Vec8::Zero();
  Mat8 hessian = Mat8::Zero();
};

PointInformation information_of(const PlaneSample& s, double residual,
                                const ContaminationTable& table) {
  using T = ContaminationTable;
  const auto v = table.derivatives(residual);
  const Eigen::Vector3d g(1, static_cast<double>(s.u), static_cast<double>(s.v));
  const Eigen::Index f = 4 + 2 * static_cast<Eigen::Index>(s.zone), b = f + 1;
  PointInformation out;
  out.score.head<3>() = -v[T::kR] * g;
  out.score[3] = v[T::kS], out.score[f] = v[T::kF], out.score[b] = v[T::kB];
  Mat8& h = out.hessian;
  h.topLeftCorner<3, 3>() = -v[T::kRR] * g * g.transpose();
  h.block<3, 1>(0, 3) = v[T::kRS] * g;
  h.block<3, 1>(0, f) = v[T::kRF] * g;
  h.block<3, 1>(0, b) = v[T::kRB] * g;
  h(3, 3) = -v[T::kSS], h(3, f) = -v[T::kSF], h(3, b) = -v[T::kSB];
  h(f, f) = -v[T::kFF], h(f, b) = -v[T::kFB], h(b, b) = -v[T::kBB];
  h.triangularView<Eigen::StrictlyLower>() = h.transpose();
  return out;
}

constexpr size_t kShared = 4, kPerZone = 2;  // unknowns of all points, and of a zone's

/// Sums of PointInformation's second derivatives and products of scores, without the zeros and what stands twice: to
/// the bit those of the matrices.
struct Sums {
  struct Entries {
    std::array<double, kShared*(kShared + 1) / 2> shared{};  ///< upper triangle, row by row
    /// Rows of the shared unknowns, then the zone's own upper triangle.
    std::array<std::array<double, kShared * kPerZone + 3>, kContaminationZones> zone{};
    Entries& operator+=(const Entries& b) {
      for (size_t k = 0; k < shared.size(); ++k) shared[k] += b.shared[k];
      for (size_t z = 0; z < kContaminationZones; ++z)
        for (size_t k = 0; k < zone[z].size(); ++k) zone[z][k] += b.zone[z][k];
      return *this;
    }
    Mat8 matrix() const {
      Mat8 out = Mat8::Zero();
      const auto set = [&](size_t i, size_t j, double value) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        out(row, column) = out(column, row) = value;
      };
      size_t k = 0;
      for (size_t i = 0; i < kShared; ++i)
        for (size_t j = i; j < kShared; ++j) set(i, j, shared[k++]);
      for (size_t z = 0; z < kContaminationZones; ++z) {
        const size_t first = kShared + kPerZone * z;
        for (size_t i = 0; i < kShared; ++i)
          for (size_t j = 0; j < kPerZone; ++j) set(i, first + j, zone[z][kPerZone * i + j]);
        set(first, first, zone[z][kShared * kPerZone]);
        set(first, first + 1, zone[z][kShared * kPerZone + 1]);
        set(first + 1, first + 1, zone[z][kShared * kPerZone + 2]);
      }
      return out;
    }
  } hessian, scores;

  Sums& operator+=(const Sums& b) {
    hessian += b.hessian;
    scores += b.scores;
    return *this;
  }
  void add(const PlaneSample& s, double residual, const ContaminationTable& table) {
    using T = ContaminationTable;
    const auto d = table.derivatives(residual);
    const double g[3] = {1, static_cast<double>(s.u), static_cast<double>(s.v)};
    const double score[kShared + kPerZone] = {-d[T::kR] * g[0], -d[T::kR] * g[1], -d[T::kR] * g[2],
                                              d[T::kS],         d[T::kF],         d[T::kB]};
    size_t k = 0;
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = i; j < 3; ++j) hessian.shared[k++] += -d[T::kRR] * g[i] * g[j];
      hessian.shared[k++] += d[T::kRS] * g[i];
    }
    hessian.shared[k] += -d[T::kSS];
    auto& zone = hessian.zone[s.zone];
    for (size_t i = 0; i < 3; ++i) {
      zone[2 * i] += d[T::kRF] * g[i];
      zone[2 * i + 1] += d[T::kRB] * g[i];
    }
    zone[6] += -d[T::kSF], zone[7] += -d[T::kSB];
    zone[8] += -d[T::kFF], zone[9] += -d[T::kFB], zone[10] += -d[T::kBB];
    k = 0;
    for (size_t i = 0; i < kShared; ++i)
      for (size_t j = i; j < kShared; ++j) scores.shared[k++] += score[i] * score[j];
    auto& own = scores.zone[s.zone];
    for (size_t i = 0; i < kShared; ++i)
      for (size_t j = 0; j < kPerZone; ++j) own[kPerZone * i + j] += score[i] * score[kShared + j];
    own[8] += score[4] * score[4], own[9] += score[4] * score[5], own[10] += score[5] * score[5];
  }
};

/// The unknowns that are free; the others drop out of matrices and vectors.
class Free {
 public:
  explicit Free(const ContaminationState& state) {
    for (size_t z = 0; z < kContaminationZones; ++z) {
      const auto f = static_cast<Eigen::Index>(4 + 2 * z);
      if (!(state.front[z] > 0)) fixed_[f] = 1;
      if (!(state.behind[z] > 0)) fixed_[f + 1] = 1;
    }
  }
  Mat8 of(Mat8 m) const {
    for (Eigen::Index k = 0; k < kContaminationStateUnknowns; ++k)
      if (fixed_[k] != 0) m.row(k).setZero(), m.col(k).setZero(), m(k, k) = 1;
    return m;
  }
  Vec8 of(const Vec8& v) const { return v.cwiseProduct(Vec8::Ones() - fixed_); }

 private:
  Vec8 fixed_ = Vec8::Zero();
};

// Column by column: Eigen's solution of all at once keeps the sizes of the processor's caches in a static variable.
Mat8 solve(const Eigen::LDLT<Mat8>& factors, const Mat8& right) {
  Mat8 out;
  for (Eigen::Index k = 0; k < kContaminationStateUnknowns; ++k)
    out.col(k) = factors.solve(Vec8(right.col(k)));
  return out;
}

Mat8 jackknife(const std::vector<PlaneSample>& samples, const ContaminationState& state,
               const std::vector<ContaminationTable>& tables, const Free& free,
               const Mat8& hessian) {
  Mat8 sum = Mat8::Zero();
  for (const PlaneSample& s : samples) {
    const PointInformation point = information_of(s, state.residual(s), tables[s.zone]);
    const Vec8 change = free.of(Mat8(hessian - point.hessian)).ldlt().solve(free.of(point.score));
    sum += change * change.transpose();
  }
  const auto n = static_cast<double>(samples.size());
  return sum * ((n - 1) / n);
}

}  // namespace

std::vector<ContaminationTable> ContaminationState::tables(double tolerance_m,
                                                           ContaminationTable::With with) const {
  std::array<Contamination, kContaminationZones> zones;
  for (size_t z = 0; z < kContaminationZones; ++z)
    zones[z] = {sigma_m, tolerance_m, front[z], behind[z]};
  return ContaminationTable::of_zones(zones, with);
}

bool contamination_covariance(const std::vector<PlaneSample>& samples,
                              const ContaminationState& state, double tolerance_m, Task& task,
                              Symmetric3& out) {
  const std::vector<ContaminationTable> tables =
      state.tables(tolerance_m, ContaminationTable::With::kDerivatives);
  const Sums sums = parallel_reduce(task, samples.size(), kContaminationStatePointsPerChunk, Sums{},
                                    [&](size_t begin, size_t end) {
                                      Sums part;
                                      for (size_t i = begin; i < end; ++i) {
                                        const PlaneSample& s = samples[i];
                                        part.add(s, state.residual(s), tables[s.zone]);
                                      }
                                      return part;
                                    });
  const Free free(state);
  const Mat8 second = sums.hessian.matrix();
  const Eigen::LDLT<Mat8> hessian(free.of(second));
  if (hessian.info() != Eigen::Success || !hessian.isPositive() ||
      !(hessian.rcond() > kLeastCondition))
    return false;
  Mat8 c;
  if (samples.size() <= kMostForJackknife) {
    c = jackknife(samples, state, tables, free, second);
  } else {
    c = solve(hessian, solve(hessian, free.of(sums.scores.matrix())).transpose());
  }
  out = {c(1, 1), c(1, 2), c(1, 0), c(2, 2), c(2, 0), c(0, 0)};
  return c.topLeftCorner<3, 3>().allFinite() && c(0, 0) > 0 && c(1, 1) > 0 && c(2, 2) > 0;
}

}  // namespace jalon
