// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/automatic.h"

#include "registration/coarse/coarse.h"
#include "registration/coarse/rows.h"
#include "registration/icp/icp.h"
#include "registration/icp/rows.h"

namespace jalon {

namespace {

constexpr auto kAutomaticRows = setting_rows(nested_rows<&AutomaticSettings::coarse, kCoarseRows>(),
                                             nested_rows<&AutomaticSettings::icp, kIcpRows>());

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
  if (!coarse.converged) return coarse;
  const ProgressSpan span(task, 0.5, 1, nullptr);
  Registration out = register_icp(reference, moving, coarse.pose, settings.icp, task);
  for (const char* name :
       {"score", "overlap_moving", "overlap_reference", "likeness", "ambiguous", "second_score"})
    out.summary.set(coarse.summary.find_shared(name));
  return out;
}

}  // namespace jalon
