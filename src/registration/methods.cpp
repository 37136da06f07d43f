// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/methods.h"

#include "base/names_of.h"
#include "registration/automatic.h"
#include "registration/coarse/coarse.h"
#include "registration/icp/icp.h"
#include "registration/registration_tables.h"
#include "registration/targets/targets.h"

namespace jalon {

namespace {

template <class Settings, Registration (*Register)(const CloudPtr&, const CloudPtr&,
                                                   const Transform&, const Settings&, Task&)>
Registration run(const CloudPtr& reference, const CloudPtr& moving, const Transform& T_start,
                 const ParamSet& params, Task& task) {
  Registration out = Register(reference, moving, T_start, settings_from<Settings>(params), task);
  if (out.judgement.verdict != Verdict::kAccepted) hide_sigmas(out);
  return out;
}

Registration run_targets(std::span<const Target> reference, std::span<const Target> moving,
                         const ParamSet& params, Task& task) {
  return register_targets(reference, moving, settings_from<TargetSettings>(params), task);
}

constexpr RegistrationMethod kMethods[] = {
    {"automatic", "registrar automatic", automatic_rows, run<AutomaticSettings, register_automatic>,
     nullptr},
    {"icp", "registrar icp", icp_rows, run<IcpSettings, register_icp>, nullptr},
    {"targets", "registrar targets", targets_rows, nullptr, run_targets},
    {"coarse", "registrar coarse", coarse_rows, run<CoarseSettings, register_coarse>, nullptr},
};

}  // namespace

std::span<const RegistrationMethod> registration_methods() { return kMethods; }
std::span<const char* const> registration_method_names() { return kNamesOf<kMethods>; }

}  // namespace jalon
