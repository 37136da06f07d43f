// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/joint_problem.h"

#include <doctest/doctest.h>

#include <string>

#include "base/error.h"

using namespace jalon;

namespace {

JointProblem whole_problem() {
  const double times[] = {0, 1}, sigmas[] = {1, 1}, drift[] = {0.01, 0.01};
  JointProblem made;
  made.x = made.y = gauss_markov(times, sigmas, drift);
  made.blocks = made.facades = 1;
  made.strips = {{0, 0, {1, 0}, {{0, 1}}, 0, 0}};
  return made;
}

template <class F>
std::string refusal_of_problem(F&& change) {
  JointProblem problem = whole_problem();
  change(problem);
  try {
    validate(problem);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("joint_problem__wrong_in_one_place__is_refused_with_a_line") {
  CHECK(refusal_of_problem([](JointProblem&) {}).empty());
  CHECK(refusal_of_problem([](JointProblem& p) { p.sigma_facade_m = -1; }) ==
        "the sigma of facades is negative");
  CHECK(refusal_of_problem([](JointProblem& p) {
          p.sigma_strip_m = 0;
        }).find("the sigma of strips is 0") == 0);
  CHECK(refusal_of_problem([](JointProblem& p) { p.strips.clear(); }) ==
        "no strip is matched: there is nothing to adjust");
  for (auto change : {+[](JointProblem& p) { p.strips[0].block = 1; },
                      +[](JointProblem& p) { p.strips[0].facade = 7; },
                      +[](JointProblem& p) {
                        p.strips[0].shares = {{2, 1.0}};
                      }})
    CHECK(refusal_of_problem(change) == "strip 0 is of a block, facade or time that is not there");
  CHECK(refusal_of_problem([](JointProblem& p) { p.y.sigmas_m.pop_back(); }) ==
        "the trajectory has 2 and 1 control positions");
}
