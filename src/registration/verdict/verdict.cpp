// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/verdict.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"

namespace jalon {

namespace {

// Of the confidence. At 0.8 the developed kinds had 1 % of their wrong poses accepted, and lost 2 % of the right ones.
constexpr double kAccepted = 0.8, kRefused = 0.1;
// What is left of the confidence where the clouds agree clearly better along a direction that the pairs leave open.
constexpr double kBetterElsewhere = 0.1;
constexpr size_t kLeastExplained = 100;  // surfels of each cloud: fewer may lie there by chance
// A scale that is off by less may be the scanners' (some 1e-4); by more, and five sigmas, the clouds differ.
constexpr double kMostScaleOff = 0.002, kScaleSigmas = 5;

// Numbers that the shares are smoothed by, and shares that count as little: what edges leave at right poses.
constexpr double kPriorSurfels = 50, kPriorExplained = 10;
constexpr double kLittleContradicted = 0.01, kLittleUnexplained = 0.02, kLittlePierced = 0.003,
                 kLittleWorst = 0.01;

// Logistic regressions (ridge 0.5) on the five kinds of scenes to develop with of tests/accuracy/pair_scenes.h, seeds
// 1 to 30: right poses, and wrong ones of the same scans, of mirrored and scaled scans, of other scenes and of other
// contents.
struct Weights {
  double constant, contradicted, unexplained, worst_pierced, pierced;
};
constexpr Weights kWithSights{5.17, -1.22, 0, -2.53, -1.73};
constexpr Weights kWithoutSights{5.18, -1.74, -1.08, 0, 0};

struct Against {
  double contradicted = 0, unexplained = 0, worst_pierced = 0, pierced = 0;  ///< shares

  void add(const Agreement& a) {
    const auto number = [](size_t n) { return static_cast<double>(n); };
    contradicted =
        std::max(contradicted, number(a.contradicted) / (number(a.judged) + kPriorSurfels));
    unexplained =
        std::max(unexplained,
                 number(a.unexplained) / (number(a.explained + a.unexplained) + kPriorExplained));
    worst_pierced = std::max(worst_pierced, a.worst_pierced);
    pierced = std::max(pierced, number(a.pierced) / (number(a.seen) + kPriorSurfels));
  }
};

double confidence_of(const Against& against, const Weights& w) {
  const auto weigh = [](double share, double little) { return std::log1p(share / little); };
  const double sum = w.constant +
                     w.contradicted * weigh(against.contradicted, kLittleContradicted) +
                     w.unexplained * weigh(against.unexplained, kLittleUnexplained) +
                     w.worst_pierced * weigh(against.worst_pierced, kLittleWorst) +
                     w.pierced * weigh(against.pierced, kLittlePierced);
  return 1 / (1 + std::exp(-sum));
}

std::string percent(double share, int decimals = 1) {
  return text_of(100 * share, decimals) + " %";
}

}  // namespace

PoseJudgement judge_pose(const PoseEvidence& evidence, bool has_converged, uint64_t unobservable) {
  PoseJudgement out;
  Against against;
  against.add(evidence.of_moving);
  against.add(evidence.of_reference);
  const size_t explained = std::min(evidence.of_moving.explained, evidence.of_reference.explained);
  const bool is_enough = explained >= kLeastExplained;
  out.confidence = confidence_of(against, evidence.has_sights() ? kWithSights : kWithoutSights);
  if (!is_enough) out.confidence *= static_cast<double>(explained) / kLeastExplained;
  if (evidence.better_m != 0) out.confidence *= kBetterElsewhere;
  // 1. What speaks against the pose.
  if (!is_enough) out.add_reason("hardly anything of one scan lies on the other");
  if (is_enough && out.confidence < kAccepted)
    out.add_reason("of the surfaces that both scans should share " + percent(against.unexplained) +
                   " differ");
  if (out.confidence < kAccepted && against.pierced > kLittlePierced)
    out.add_reason("one scan looked through " + percent(against.pierced) +
                   " of the surfaces of the other");
  if (evidence.better_m != 0)
    out.add_reason("slid by " + text_of(std::abs(evidence.better_m), 2) +
                   " m along a direction that the data leave open the scans agree better");
  // 2. What leaves it open.
  const ScaleTest& scale = evidence.scale;
  if (scale.sigma > 0 &&
      std::abs(scale.scale - 1) > std::max(kMostScaleOff, kScaleSigmas * scale.sigma))
    out.add_reason("the scans differ in scale by about " + percent(std::abs(scale.scale - 1), 2));
  if (unobservable > 0)
    out.add_reason(std::to_string(unobservable) +
                   " of the six directions of the pose are not fixed by the data");
  if (!has_converged) out.add_reason("the steps have not settled");
  out.verdict = out.confidence <= kRefused ? Verdict::kRefused
                : out.reasons.empty()      ? Verdict::kAccepted
                                           : Verdict::kDoubtful;
  return out;
}

}  // namespace jalon
