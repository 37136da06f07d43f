// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/verdict.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

Agreement clean_agreement() {
  Agreement out;
  out.surfels = 4000;
  out.near = 2000;
  out.explained = 1900;
  out.unexplained = 20;
  out.seen = 3000;
  out.judged = 1920;
  out.has_sights = true;
  return out;
}

PoseEvidence clean_evidence() {
  PoseEvidence out;
  out.of_moving = out.of_reference = clean_agreement();
  out.scale = {1.00001, 0.0001, 1500};
  return out;
}

bool has_reason(const PoseJudgement& judgement, const char* words) {
  return judgement.reasons.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("verdict__accepts_a_pose_that_nothing_speaks_against") {
  const PoseJudgement found = judge_pose(clean_evidence(), true, 0);
  CHECK(found.verdict == Verdict::kAccepted);
  CHECK(found.confidence > 0.95);
  CHECK(found.confidence <= 1);
  CHECK(found.reasons.empty());
}

TEST_CASE("verdict__refuses_a_pose_that_beams_go_through") {
  PoseEvidence evidence = clean_evidence();
  evidence.of_moving.pierced = 300;
  evidence.of_moving.contradicted = 300;
  evidence.of_moving.judged += 300;
  evidence.of_moving.worst_pierced = 0.3;
  const PoseJudgement found = judge_pose(evidence, true, 0);
  CHECK(found.verdict == Verdict::kRefused);
  CHECK(found.confidence < 0.1);
  CHECK(has_reason(found, "looked through"));
}

TEST_CASE("verdict__is_less_sure_the_more_is_contradicted_on_either_side") {
  for (const bool of_reference : {false, true}) {
    double last = 1;
    for (const size_t things : {0, 40, 100, 200, 400, 800}) {
      PoseEvidence evidence = clean_evidence();
      Agreement& side = of_reference ? evidence.of_reference : evidence.of_moving;
      side.contradicted = side.unexplained = things;
      side.judged = side.explained + things;
      const double confidence = judge_pose(evidence, true, 0).confidence;
      CHECK(confidence < last);
      last = confidence;
    }
    CHECK(last < 0.8);
  }
}

TEST_CASE("verdict__is_doubtful_with_its_reason_where_something_stays_open") {
  CHECK(has_reason(judge_pose(clean_evidence(), true, 2), "2 of the six directions"));
  CHECK(has_reason(judge_pose(clean_evidence(), false, 0), "not settled"));
  PoseEvidence scaled = clean_evidence();
  scaled.scale = {1.01, 0.0005, 1500};
  CHECK(has_reason(judge_pose(scaled, true, 0), "scale by about 1.00 %"));
  for (const PoseJudgement& found :
       {judge_pose(clean_evidence(), true, 2), judge_pose(clean_evidence(), false, 0),
        judge_pose(scaled, true, 0)})
    CHECK(found.verdict == Verdict::kDoubtful);
}

TEST_CASE("verdict__does_not_mind_a_scale_that_scanners_differ_by_or_that_is_not_sure") {
  PoseEvidence evidence = clean_evidence();
  evidence.scale = {1.0005, 0.00001, 1500};
  CHECK(judge_pose(evidence, true, 0).verdict == Verdict::kAccepted);
  evidence.scale = {1.01, 0.01, 1500};
  CHECK(judge_pose(evidence, true, 0).verdict == Verdict::kAccepted);
  evidence.scale = {};
  CHECK(judge_pose(evidence, true, 0).verdict == Verdict::kAccepted);
}

TEST_CASE("verdict__refuses_clouds_that_hardly_meet") {
  PoseEvidence evidence;
  const PoseJudgement nothing = judge_pose(evidence, true, 0);
  CHECK(nothing.verdict == Verdict::kRefused);
  CHECK(nothing.confidence == 0);
  CHECK(has_reason(nothing, "hardly anything"));
  evidence = clean_evidence();
  evidence.of_moving.explained = 30;
  CHECK(judge_pose(evidence, true, 0).verdict == Verdict::kDoubtful);
}

TEST_CASE("verdict__is_less_sure_where_nobody_knows_the_stations") {
  PoseEvidence evidence = clean_evidence();
  evidence.of_moving.has_sights = false;
  CHECK(judge_pose(evidence, true, 0).confidence <
        judge_pose(clean_evidence(), true, 0).confidence);
}
