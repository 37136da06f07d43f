// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/methods.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "accuracy/registration_pairs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const RegistrationMethod& method(std::string_view name) {
  for (const RegistrationMethod& m : registration_methods())
    if (m.name == name) return m;
  FAIL("no such method");
  return registration_methods()[0];
}

Registration run(const char* name, uint64_t contents_of_moving) {
  Task task;
  ScanSettings scanner;
  scanner.is_turned = false;
  const RegistrationMethod& m = method(name);
  return m.run(scan_from(furnished(4, 4), 0, scanner, 1).cloud,
               scan_from(furnished(4, contents_of_moving), 1, scanner, 2).cloud, {},
               ParamSet(m.owner, m.rows()), task);
}

}  // namespace

TEST_CASE("registration_methods__give_sigmas_of_accepted_poses_alone") {
  for (const char* name : {"icp", "automatic"}) {
    const Registration right = run(name, 4), wrong = run(name, 99);
    CHECK(right.judgement.verdict == Verdict::kAccepted);
    CHECK(std::isfinite(right.summary.require("covariance").values<double>()[0]));
    CHECK(std::isfinite(right.directions.require("sigma").values<double>()[0]));
    CHECK(wrong.judgement.verdict != Verdict::kAccepted);
    for (const double c : wrong.summary.require("covariance").values<double>())
      CHECK(std::isnan(c));
    for (const double c : wrong.covariance) CHECK(std::isnan(c));
    for (const double s : wrong.directions.require("sigma").values<double>()) CHECK(std::isnan(s));
  }
}

TEST_CASE("registration_methods__have_what_their_names_promise") {
  CHECK(registration_methods().size() == registration_method_names().size());
  for (const RegistrationMethod& m : registration_methods()) {
    CHECK((m.run != nullptr) != (m.run_targets != nullptr));
    CHECK_FALSE(m.rows().empty());
  }
}
