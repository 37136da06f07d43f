// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/judge.h"

#include "base/numbers.h"
#include "base/table_columns.h"
#include "registration/registration_tables.h"
#include "registration/surface/steady_planes.h"
#include "registration/verdict/verdict.h"

namespace jalon {

namespace {

void add_evidence(const PoseEvidence& evidence, FieldTable& summary) {
  const auto add = [&](const char* name, const char* meaning, double of_moving,
                       double of_reference) {
    add_value<double>(summary, std::string(name) + "_moving", "1", meaning, of_moving);
    add_value<double>(summary, std::string(name) + "_reference", "1", meaning, of_reference);
  };
  const Agreement &m = evidence.of_moving, &r = evidence.of_reference;
  add("near", "share of the surface within reach of the other cloud", m.near_share(),
      r.near_share());
  add("explained", "share of what the other scan could see that lies on its surface",
      m.explained_share(), r.explained_share());
  add("pierced", "share of what the other scan could see where its beams went through",
      m.has_sights ? m.pierced_share() : kNaN, r.has_sights ? r.pierced_share() : kNaN);
  add("contradicted", "share that differs together with what is about it", m.contradicted_share(),
      r.contradicted_share());
  const bool has_scale = evidence.scale.sigma > 0;
  add_value<double>(summary, "wanted_scale", "1", "of the moving cloud, if it were free",
                    has_scale ? evidence.scale.scale : kNaN);
  add_value<double>(summary, "wanted_scale_sigma", "1", "its standard deviation",
                    has_scale ? evidence.scale.sigma : kNaN);
}

}  // namespace

IcpJudged icp_judged(const Cloud& reference, const Cloud& moving, const IcpProblem& problem,
                     double misfit_m, Task& task) {
  const IcpClouds& clouds = problem.clouds;
  IcpJudged out;
  const SurfacePlanes *of_reference = &clouds.reference, *of_moving = &clouds.moving;
  const bool is_of_lines = problem.cells.do_widen;
  if (is_of_lines) {
    const auto steady = [&](const SurfacePlanes& surface) {
      return std::make_unique<const SurfacePlanes>(
          steady_planes(surface, problem.settings.k, task));
    };
    out.steady_reference = steady(clouds.reference), out.steady_moving = steady(clouds.moving);
    of_reference = out.steady_reference.get(), of_moving = out.steady_moving.get();
  }
  out.reference =
      judged_cloud(reference, *of_reference, problem.thinned_reference.index, task, is_of_lines);
  out.moving = judged_cloud(moving, *of_moving, problem.thinned_moving.index, task, is_of_lines);
  out.reference.misfit_m = out.moving.misfit_m = misfit_m;
  return out;
}

void icp_judge(const IcpJudged& judged, const IcpState& state, double better_m, Registration& out,
               Task& task) {
  PoseEvidence evidence =
      evidence_of(judged.reference, judged.moving, state.T_reference_moving, task);
  evidence.better_m = better_m;
  add_evidence(evidence, out.summary);
  fill_judgement(out, judge_pose(evidence, out.converged, out.unobservable));
}

}  // namespace jalon
