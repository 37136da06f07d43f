// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/judge.h"

#include <doctest/doctest.h>

#include "accuracy/registration_pairs.h"
#include "registration/icp/icp.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double value(const Registration& r, const char* name) {
  return r.summary.require(name).values<double>()[0];
}

Registration registered(const CloudPtr& reference, const CloudPtr& moving, double cell_m = 0) {
  Task task;
  IcpSettings settings;
  settings.cell_m = cell_m;
  return register_icp(reference, moving, {}, settings, task);
}

StandScan room_scan(size_t standpoint, uint64_t contents) {
  ScanSettings scanner;
  scanner.is_turned = false;
  return scan_from(furnished(3, contents), standpoint, scanner, standpoint + 1);
}

}  // namespace

TEST_CASE("icp_judge__adds_its_findings_and_accepts_a_right_pose") {
  for (const double cell_m : {0.0, 0.05}) {  // of all points, and of thinned ones
    const Registration r = registered(room_scan(0, 3).cloud, room_scan(1, 3).cloud, cell_m);
    CHECK(r.judgement.verdict == Verdict::kAccepted);
    CHECK(r.judgement.reasons.empty());
    CHECK(r.summary.require("verdict").values<uint8_t>()[0] == 1);
    CHECK(value(r, "confidence") == r.judgement.confidence);
    CHECK(value(r, "explained_moving") > 0.9);
    CHECK(value(r, "explained_reference") > 0.9);
    CHECK(value(r, "pierced_moving") < 0.01);
    CHECK(value(r, "near_moving") > 0.3);
    CHECK(value(r, "wanted_scale") == doctest::Approx(1).epsilon(1e-3));
    CHECK(value(r, "wanted_scale_sigma") > 0);
  }
}

TEST_CASE("icp_judge__does_not_accept_another_floor_that_converges") {
  const Registration r = registered(room_scan(0, 3).cloud, room_scan(1, 77).cloud);
  CHECK(r.converged);
  CHECK(r.judgement.verdict != Verdict::kAccepted);
  CHECK_FALSE(r.judgement.reasons.empty());
}
