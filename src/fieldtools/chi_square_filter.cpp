// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "cloud/neighbourhoods.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/field_values.h"
#include "fieldtools/range_counts.h"
#include "fieldtools/range_values.h"
#include "spatial/neighbours/many_in_ball.h"

namespace jalon {

namespace {

constexpr size_t kChiSquareFilterGrain = 1 << 14;
constexpr uint32_t kChiSquareFilterMostClasses = 32;  // reached at 1 024 values
constexpr double kLeastExpected =
    1e-3;  // floor of n P_i in relaxed classes: no overflow, a wide range for the cut
constexpr double kShareForSingles =
    0.03;  // of the points: a search by itself costs some 30 of a batch

/// Outcome of one test, in units of the cut of the first pass: distances of tests with other numbers of classes are
/// brought to it by the ratio of the tabulated cuts.
struct Outcome {
  double distance = kNaN;
  double saturating = 0;  ///< the same over equally probable classes, which the band is about
  bool above = false;     ///< deviations above those of the law
};

struct ChiSquareFilterScratch {
  std::vector<double> work;
};

static_assert(kManyInRanges >= kChiSquareFilterMostClasses * kChiSquareFilterMostClasses,
              "balls that go by ranges have all classes");
using ClassCounts = RangeCounts<kChiSquareFilterMostClasses>;

/// The test of one neighbourhood against the law.
class LocalTest {
 public:
  LocalTest(const NoiseLaw& law, const ChiSquareSettings& settings, const ValuedPoints& valued,
            Task& task)
      : law_(law), settings_(settings), valued_(valued), deviation_(expected_deviation(law)) {
    for (uint32_t k = 2; k <= kChiSquareFilterMostClasses; ++k)
      thresholds_[k] = chi_square_threshold(k, settings.error_margin);
    cumulative_.resize(valued.size());
    parallel_for(task, valued.size(), kChiSquareFilterGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) cumulative_[i] = law.cumulative(valued.values[i]);
    });
  }

  double tabulated() const {
    return settings_.kolmogorov()
               ? kolmogorov_cut(settings_.neighbours)
               : thresholds_[classes_for(settings_.neighbours, kChiSquareFilterMostClasses)];
  }
  double ceiling() const {
    if (settings_.kolmogorov()) return 1;
    if (settings_.relaxed()) return std::numeric_limits<double>::infinity();
    return settings_.neighbours *
           (classes_for(settings_.neighbours, kChiSquareFilterMostClasses) - 1.0);
  }

  Outcome run(std::span<const uint32_t> members, ChiSquareFilterScratch& scratch) const {
    if (members.size() < kFewestTested) return {};
    Outcome out;
    if (settings_.kolmogorov()) {
      scratch.work.clear();
      for (const uint32_t j : members) scratch.work.push_back(cumulative_[j]);
      out.distance =
          kolmogorov_distance(scratch.work) * tabulated() / kolmogorov_cut(members.size());
      out.saturating = out.distance;
    } else {
      const uint32_t k = classes_for(members.size(), kChiSquareFilterMostClasses);
      const double to_first = tabulated() / thresholds_[k];
      out.saturating = equiprobable(members, k) * to_first;
      out.distance = settings_.relaxed() ? relaxed(members, k) * to_first : out.saturating;
    }
    double sum = 0;
    for (const uint32_t j : members) sum += deviation_.of(valued_.values[j]);
    out.above = sum > deviation_.mean * static_cast<double>(members.size());
    return out;
  }

  /// The tests of the neighbourhoods of those points of which is_wanted(point) holds.
  template <class IsWanted>
  void each(uint32_t k, double radius_m, Task& task, IsWanted is_wanted,
            std::vector<Outcome>& outcomes) const {
    const auto of_list = [&](const Neighbourhood& around, ChiSquareFilterScratch& scratch) {
      if (is_wanted(around.point)) outcomes[around.point] = run(around.neighbours, scratch);
    };
    // The other tests need the values themselves, in order.
    if (!(radius_m > 0) || settings_.kolmogorov() || settings_.relaxed())
      return for_each_neighbourhood<ChiSquareFilterScratch>(*valued_.tree, k, radius_m, task,
                                                            of_list);
    std::vector<double> deviations(valued_.size());
    std::vector<uint8_t> classes(valued_.size());
    parallel_for(task, valued_.size(), kChiSquareFilterGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        deviations[i] = deviation_.of(valued_.values[i]);
        classes[i] = static_cast<uint8_t>(class_of(i, kChiSquareFilterMostClasses));
      }
    });
    const RangeValues<std::plus<>> sums(deviations, std::plus<>());
    const ClassCounts counts(std::move(classes));
    valued_.tree->for_each_ranged_ball(
        radius_m, task,
        [&](const Octree::BallBatch& batch) {
          visit_balls<ChiSquareFilterScratch>(*valued_.tree, batch, of_list);
        },
        [&](const Octree::RangedBall& ball) {
          if (is_wanted(ball.point)) outcomes[ball.point] = run(ball, sums, counts);
        });
  }

 private:
  /// As of a list of so many members that their classes are the most there are.
  Outcome run(const Octree::RangedBall& ball, const RangeValues<std::plus<>>& sums,
              const ClassCounts& counts) const {
    constexpr uint32_t k = kChiSquareFilterMostClasses;
    ClassCounts::Counts in_ball{};
    double sum = 0;
    for (const Octree::PointRange& range : ball.ranges) {
      counts.add(range.first, range.last, in_ball);
      sum = sums.over(range.first, range.last, sum);
    }
    Outcome out;
    const auto n = static_cast<double>(ball.count);
    out.saturating = out.distance = distance_of(in_ball, k, n) * (tabulated() / thresholds_[k]);
    out.above = sum > deviation_.mean * n;
    return out;
  }

  uint32_t class_of(size_t i, uint32_t k) const {
    return std::min(k - 1, static_cast<uint32_t>(cumulative_[i] * k));
  }
  static double distance_of(const ClassCounts::Counts& counts, uint32_t k, double n) {
    uint64_t squares = 0;  // sum (N - n/k)^2 / (n/k) = k / n sum N^2 - n
    for (uint32_t c = 0; c < k; ++c) squares += uint64_t{counts[c]} * counts[c];
    return static_cast<double>(squares) * k / n - n;
  }
  /// Sample sizes of an empirical law count, as in a test of two samples.
  double kolmogorov_cut(size_t n) const {
    return kolmogorov_threshold(n, law_.kind == LawKind::kEmpirical ? law_.samples : 0,
                                settings_.error_margin);
  }

  double equiprobable(std::span<const uint32_t> members, uint32_t k) const {
    ClassCounts::Counts counts{};
    for (const uint32_t j : members) ++counts[class_of(j, k)];
    return distance_of(counts, k, static_cast<double>(members.size()));
  }

  /// Classes of one width from 0 (the least value of a signed law) to the largest value; the outer ones are open.
  double relaxed(std::span<const uint32_t> members, uint32_t k) const {
    double low = deviation_.two_sided ? std::numeric_limits<double>::infinity() : 0,
           high = low == 0 ? 0 : -low;
    for (const uint32_t j : members) {
      low = std::min(low, valued_.values[j]);
      high = std::max(high, valued_.values[j]);
    }
    const double width = (high - low) / k;
    std::array<uint32_t, kChiSquareFilterMostClasses> counts{};
    for (const uint32_t j : members)
      ++counts[width > 0 ? std::min(k - 1, static_cast<uint32_t>((valued_.values[j] - low) / width))
                         : 0];
    const auto n = static_cast<double>(members.size());
    double distance = 0, from = 0;
    for (uint32_t c = 0; c < k; ++c) {
      const double to = c + 1 == k ? 1 : law_.cumulative(low + (c + 1) * width);
      const double expected = std::max(kLeastExpected, n * (to - from)), d = counts[c] - expected;
      distance += d * d / expected;
      from = to;
    }
    return distance;
  }

  const NoiseLaw& law_;
  const ChiSquareSettings& settings_;
  const ValuedPoints& valued_;
  ExpectedDeviation deviation_;
  std::array<double, kChiSquareFilterMostClasses + 1> thresholds_{};
  std::vector<double> cumulative_;  ///< F of each value, by sorted position
};

double cut_of(const ChiSquareSettings& settings, const NoiseLaw& law, const LocalTest& test) {
  using Threshold = ChiSquareSettings::Threshold;
  if (settings.threshold == Threshold::kTabulated) return test.tabulated();
  if (settings.threshold == Threshold::kGiven) {
    if (!(settings.cut > 0)) fail(Status::kInvalidArgument, "threshold is given, but cut is 0");
    return settings.cut;
  }
  if (settings.kolmogorov())
    fail(Status::kInvalidArgument, "the empirical threshold is one of method chi_square");
  if (!(law.sample_chi_square > 0))
    fail(Status::kInvalidArgument,
         "the noise law does not tell its distance to a sample: no empirical threshold");
  return law.sample_chi_square;
}

/// The second pass: the points of the band, with more neighbours.
class SecondPass {
 public:
  SecondPass(const Cloud& cloud, const ValuedPoints& valued, const ChiSquareSettings& settings,
             const LocalTest& test)
      : cloud_(cloud), valued_(valued), settings_(settings), test_(test) {}

  uint64_t run(std::vector<Outcome>& outcomes, Task& task) const {
    const double low = settings_.band_low * test_.tabulated(),
                 high = settings_.band_high * test_.tabulated();
    std::vector<uint32_t> band;
    std::vector<uint8_t> in_band(outcomes.size());
    serial_for(task, outcomes.size(), kChiSquareFilterGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Outcome& o = outcomes[i];
        if (std::isnan(o.distance) || !(o.saturating >= low && o.saturating <= high)) continue;
        in_band[i] = 1;
        band.push_back(static_cast<uint32_t>(i));
      }
    });
    const bool few =
        static_cast<double>(band.size()) < kShareForSingles * static_cast<double>(outcomes.size());
    if (settings_.radius_m > 0 || !few) {
      all_neighbourhoods(in_band, outcomes, task);
    } else {
      single_neighbourhoods(band, outcomes, task);
    }
    return band.size();
  }

 private:
  void all_neighbourhoods(const std::vector<uint8_t>& in_band, std::vector<Outcome>& outcomes,
                          Task& task) const {
    const double grown =
        std::sqrt(static_cast<double>(settings_.second_neighbours) / settings_.neighbours);
    test_.each(
        settings_.second_neighbours, settings_.radius_m * grown, task,
        [&](size_t point) { return in_band[point] != 0; }, outcomes);
  }

  /// The same neighbours: both searches are exact with the same order of ties.
  void single_neighbourhoods(const std::vector<uint32_t>& band, std::vector<Outcome>& outcomes,
                             Task& task) const {
    const auto order = valued_.tree->order();
    std::vector<uint32_t> position(order.size());
    parallel_for(task, order.size(), kChiSquareFilterGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) position[order[i]] = static_cast<uint32_t>(i);
    });
    constexpr size_t kBandGrain = 256;
    parallel_for(task, band.size(), kBandGrain, [&](size_t begin, size_t end) {
      ChiSquareFilterScratch scratch;
      std::vector<Neighbour> found(settings_.second_neighbours);
      std::vector<uint32_t> members(found.size());
      for (size_t i = begin; i < end; ++i) {
        const Vec3 at = cloud_.point(valued_.points[band[i]]);
        const size_t n = valued_.tree->knn(at, settings_.second_neighbours, found);
        for (size_t j = 0; j < n; ++j) members[j] = position[found[j].index];
        outcomes[band[i]] = test_.run({members.data(), n}, scratch);
      }
    });
  }

  const Cloud& cloud_;
  const ValuedPoints& valued_;
  const ChiSquareSettings& settings_;
  const LocalTest& test_;
};

void hand_out(const ValuedPoints& valued, const std::vector<Outcome>& outcomes, bool one_sided,
              ChangeFilter& out, Task& task) {
  serial_for(task, outcomes.size(), kChiSquareFilterGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Outcome& o = outcomes[i];
      const uint32_t point = valued.points[i];
      if (std::isnan(o.distance)) continue;
      out.distance[point] = o.distance;
      out.changed[point] = o.distance > out.threshold && (o.above || !one_sided);
      ++out.tested;
      out.changed_count += out.changed[point];
    }
  });
}

}  // namespace

ChangeFilter filter_changes(const Cloud& cloud, std::span<const double> values, const NoiseLaw& law,
                            const ChiSquareSettings& settings, Task& task) {
  ChangeFilter out;
  out.distance.assign(values.size(), kNaN);
  out.changed.assign(values.size(), 0);
  ValuedPoints valued;
  {
    ProgressSpan span(task, 0, 0.2, "index");
    valued = valued_points(cloud, values, task);
  }
  if (valued.size() < kFewestTested)
    fail(Status::kInsufficientData, "%zu points have a value; the filter needs at least %u",
         valued.size(), kFewestTested);
  ProgressSpan span(task, 0.2, 1, "local test");
  const LocalTest test(law, settings, valued, task);
  out.threshold = cut_of(settings, law, test);
  out.ceiling = test.ceiling();
  // 1. Every neighbourhood.
  std::vector<Outcome> outcomes(valued.size());
  {
    ProgressSpan first(task, 0, settings.passes == 2 ? 0.5 : 0.95);
    test.each(
        settings.neighbours, settings.radius_m, task, [](size_t) { return true; }, outcomes);
  }
  // 2. Those near the limit again.
  if (settings.passes == 2) {
    ProgressSpan second(task, 0.5, 0.95);
    out.second_pass = SecondPass(cloud, valued, settings, test).run(outcomes, task);
  }
  // 3. What lies above the cut has changed.
  hand_out(valued, outcomes, settings.one_sided, out, task);
  return out;
}

}  // namespace jalon
