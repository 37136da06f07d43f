// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/automatic.h"

#include <algorithm>
#include <vector>

#include "registration/coarse/coarse.h"
#include "registration/coarse/rows.h"
#include "registration/icp/icp.h"
#include "registration/icp/rows.h"
#include "registration/registration_tables.h"

namespace jalon {

namespace {

constexpr auto kAutomaticRows = setting_rows(nested_rows<&AutomaticSettings::coarse, kCoarseRows>(),
                                             nested_rows<&AutomaticSettings::icp, kIcpRows>());

// Score of a pose, of the best one's, below which none was right where the best was not: repeated facades and streets
// of two stations came to 0.67 and 0.69.
constexpr double kWorthTrying = 0.5;
// Poses that put the moving cloud's centre or its outer points farther apart than this share of its extent are
// different.
constexpr double kDifferent = 0.02;

struct CoarsePose {
  Transform T_reference_moving;
  double score = 0;
};

// Step 2: the poses that coarse found, the best first; with repeated facades the right one is often the fourth.
std::vector<CoarsePose> poses_of(const Registration& coarse) {
  const auto scores = coarse.iteration_log.require("score").values<double>();
  const auto rows = coarse.iteration_log.require("pose").values<double>();
  std::vector<CoarsePose> out(scores.size());
  for (size_t i = 0; i < out.size(); ++i) {
    std::copy_n(rows.begin() + static_cast<ptrdiff_t>(12 * i), 12,
                out[i].T_reference_moving.m.begin());
    out[i].score = scores[i];
  }
  return out;
}

bool is_accepted(const Registration& r) { return r.judgement.verdict == Verdict::kAccepted; }

bool are_different(const Registration& a, const Registration& b) {
  const Transform away = a.pose * inverse(b.pose);
  const double most_m = kDifferent * b.extent_m;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 arm;
    arm[axis] = b.extent_m;
    if (norm(away.point(b.centre + arm) - (b.centre + arm)) > most_m) return true;
  }
  return norm(away.point(b.centre) - b.centre) > most_m;
}

// Step 3: fine registration from the poses in turn, until one is accepted and no rival of it is left.
std::vector<Registration> refined(const CloudPtr& reference, const CloudPtr& moving,
                                  const Registration& coarse, const AutomaticSettings& settings,
                                  Task& task) {
  std::vector<Registration> out;
  const std::vector<CoarsePose> poses = poses_of(coarse);
  // Those below are not tried; of an accepted one, they are no rivals.
  double least_score = poses.empty() ? 0 : kWorthTrying * poses[0].score;
  bool has_accepted = false;
  for (size_t i = 0; i < poses.size() && poses[i].score >= least_score; ++i) {
    const double whole = static_cast<double>(poses.size());
    const ProgressSpan span(task, static_cast<double>(i) / whole,
                            static_cast<double>(i + 1) / whole, nullptr);
    out.push_back(register_icp(reference, moving, poses[i].T_reference_moving, settings.icp, task));
    if (!has_accepted && is_accepted(out.back())) {
      has_accepted = true;
      least_score = settings.coarse.ambiguous_percent / 100 * poses[i].score;
    }
  }
  return out;
}

// Step 4: the one that is accepted. With two that differ the pose is ambiguous; with none it stays as coarse has it,
// or, where that was sure, as the first fine one has it.
Registration chosen(const Registration& coarse, std::vector<Registration> fine) {
  const auto best = std::ranges::find_if(fine, is_accepted);
  if (best == fine.end()) return coarse.converged && !fine.empty() ? std::move(fine[0]) : coarse;
  const bool has_rival = std::any_of(best + 1, fine.end(), [&](const Registration& r) {
    return is_accepted(r) && are_different(r, *best);
  });
  Registration out = std::move(*best);
  if (!has_rival) return out;
  out.converged = false;
  out.stopped = StopReason::kAmbiguous;
  set_stopped(out);
  PoseJudgement judgement = judgement_of_search(out.stopped);
  judgement.confidence = out.judgement.confidence / 2;  // one of two that look alike
  fill_judgement(out, std::move(judgement));
  return out;
}

}  // namespace

std::span<const ParamRow> automatic_rows() { return kAutomaticRows; }

Registration register_automatic(const CloudPtr& reference, const CloudPtr& moving,
                                const Transform& T_start, const AutomaticSettings& settings,
                                Task& task) {
  Registration coarse;
  {
    const ProgressSpan span(task, 0, 0.5, nullptr);
    coarse = register_coarse(reference, moving, T_start, settings.coarse, task);
  }
  const ProgressSpan span(task, 0.5, 1, nullptr);
  Registration out = chosen(coarse, refined(reference, moving, coarse, settings, task));
  for (const char* name :
       {"score", "overlap_moving", "overlap_reference", "likeness", "ambiguous", "second_score"})
    out.summary.set(coarse.summary.find_shared(name));
  return out;
}

}  // namespace jalon
