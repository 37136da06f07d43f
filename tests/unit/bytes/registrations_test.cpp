// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/registrations.h"

#include <doctest/doctest.h>

#include "registration/registration_tables.h"
#include "unit/bytes/bytes_back.h"

namespace jalon {
namespace {

using test::has_text;

Registration registration_of_two_pairs() {
  Registration r;
  r.pose.m[3] = 652000.125;
  r.converged = true;
  r.stopped = StopReason::kConverged;
  r.covariance[35] = 1e-7;
  r.rms_m = 0.003;
  r.residuals.set(make_column<double>({"residual"}, std::vector<double>{0.1, 0.2}));
  r.pair_names = {"A", "B\xC3\xA9"};
  r.parameters_json = "{\"k\":12}";
  fill_tables(r, {});
  fill_judgement(r, {Verdict::kDoubtful, 0.5, "the steps have not settled"});
  return r;
}

template <class F>
std::string registration_back(F&& change, Registration* out = nullptr) {
  Registration from = registration_of_two_pairs();
  change(from);
  return test::bytes_back([&](ByteWriter& w) { write_registration(w, from); },
                          [&](ByteReader& r, Task& task) {
                            Registration back = read_registration(r, task);
                            if (out != nullptr) *out = std::move(back);
                          });
}

TEST_CASE("registration_bytes__bring_back_pose_covariance_tables_and_names") {
  Registration back;
  CHECK(registration_back([](Registration&) {}, &back) == "");
  const Registration from = registration_of_two_pairs();
  CHECK(back.pose.m == from.pose.m);
  CHECK(back.covariance == from.covariance);
  CHECK(back.converged);
  CHECK(back.stopped == StopReason::kConverged);
  CHECK(back.judgement.verdict == Verdict::kDoubtful);
  CHECK(back.judgement.confidence == 0.5);
  CHECK(back.judgement.reasons == from.judgement.reasons);
  CHECK(back.pair_names == from.pair_names);
  CHECK(back.directions.require("direction").info().components == 6);
  CHECK(back.summary.require("rms").number(0) == 0.003);
  CHECK(back.parameters_json == from.parameters_json);
}

TEST_CASE("registration_bytes__that_no_registrar_could_have_made_are_refused") {
  using R = Registration;
  CHECK(has_text(registration_back([](R& r) { r.pose.m[0] = INFINITY; }), "pose is not finite"));
  CHECK(has_text(registration_back([](R& r) { r.stopped = static_cast<StopReason>(6); }),
                 "reason for the end"));
  CHECK(has_text(registration_back([](R& r) { r.judgement.verdict = static_cast<Verdict>(4); }),
                 "verdict is unknown"));
  CHECK(has_text(registration_back([](R& r) { r.pair_names.resize(3); }), "more names than pairs"));
  CHECK(has_text(registration_back([](R& r) { r.directions.remove("sigma"); }),
                 "no column \"sigma\""));
  CHECK(has_text(registration_back([](R& r) { r.summary = {}; }), "no column \"converged\""));
}

}  // namespace
}  // namespace jalon
