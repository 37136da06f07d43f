// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/options.h"

namespace jalon::cli {

/// What "jalon scan --method mobile" is told.
struct DriveScan {
  const Settings& scanner;  ///< of method "mobile"
  const Settings& street;   ///< of operation "street_drive", of a scenario "drive_scenario"
  const std::string &output, &model_output, &trajectory_output;
  int64_t drift_seed;  ///< 0: no errors
  int64_t scenario;    ///< 1 to 5: of Monnier (2014); 0: by sigmas; -1: no errors of the model
};
/// Drives through the street and writes what a user has: a trajectory with errors, the cloud that it makes of what was
/// measured, and the model of the street. Of a scenario the model has errors too, and what is true is written beside.
void scan_by_drive(const DriveScan& scan, const Common& common);

}  // namespace jalon::cli
