// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/evaluations.h"

#include <doctest/doctest.h>

#include "unit/bytes/bytes_back.h"

namespace jalon {
namespace {

using test::has_text;

TEST_CASE("evaluation_bytes__bring_back_pairs_verdicts_and_totals") {
  Evaluation evaluation, back;
  evaluation.pairs = {{1, 2, 30, 40, 20, 0.1, 0.2, -0.3}};
  evaluation.automatic = {{30, false, 2, 1, 20}};
  evaluation.reference = {{40, true, 1, 1, 20}, {}};
  evaluation.automatic_source = {-7};
  evaluation.reference_source = {5, 6};
  evaluation.totals.offset_m.deviation = 0.5;
  const auto write = [&](ByteWriter& w) { write_evaluation(w, evaluation); };
  const auto read = [&](ByteReader& r, Task&) { back = read_evaluation(r); };
  CHECK(test::bytes_back(write, read) == "");
  CHECK(back.pairs.at(0).offset_m == -0.3);
  CHECK(!back.automatic.at(0).kept);
  CHECK(back.reference_source == evaluation.reference_source);
  CHECK(back.totals.offset_m.deviation == 0.5);
  evaluation.automatic_source.clear();
  CHECK(has_text(test::bytes_back(write, read), "differ in number"));
}

TEST_CASE("evaluation_bytes__of_pairs_that_share_more_than_they_have_are_refused") {
  Evaluation evaluation, back;
  const auto write = [&](ByteWriter& w) { write_evaluation(w, evaluation); };
  const auto read = [&](ByteReader& r, Task&) { back = read_evaluation(r); };
  const auto with_pair = [&](uint64_t automatic, uint64_t reference, uint64_t intersection) {
    evaluation.pairs = {{1, 2, automatic, reference, intersection, 0, 0, 0}};
    return test::bytes_back(write, read);
  };
  CHECK(with_pair(20, 30, 20) == "");
  CHECK(has_text(with_pair(20, 30, 21), "shares more points"));
  CHECK(has_text(with_pair(30, 20, 21), "shares more points"));
  CHECK(has_text(with_pair(UINT64_MAX, 1, 1), "shares more points"));
  evaluation.pairs.clear();
  evaluation.totals.card_automatic = evaluation.totals.card_reference = 5;
  CHECK(test::bytes_back(write, read) == "");
  evaluation.totals.intersection = 6;
  CHECK(has_text(test::bytes_back(write, read), "shares more points"));
}

TEST_CASE("model_evaluation_bytes__bring_back_pairs_that_lead_to_faces") {
  ModelEvaluation evaluation, back;
  evaluation.automatic.resize(2);
  evaluation.reference.resize(1);
  evaluation.pairs.resize(1);
  evaluation.pairs[0].automatic = 1;
  evaluation.pairs[0].borders.reference.q95_m = 0.25;
  evaluation.vertices.resize(1);
  evaluation.vertices[0].deviation = {1, 2, 3};
  evaluation.shift = {0, 0, 4};
  evaluation.formulas = IndexFormulas::kThesis;
  const auto write = [&](ByteWriter& w) { write_model_evaluation(w, evaluation); };
  const auto read = [&](ByteReader& r, Task&) { back = read_model_evaluation(r); };
  CHECK(test::bytes_back(write, read) == "");
  CHECK(back.pairs.at(0).borders.reference.q95_m == 0.25);
  CHECK(back.vertices.at(0).deviation == Vec3{1, 2, 3});
  CHECK(back.shift.z == 4);
  CHECK(back.formulas == IndexFormulas::kThesis);
  evaluation.pairs[0].automatic = 2;
  CHECK(has_text(test::bytes_back(write, read), "a face that is not there"));
  evaluation.pairs.clear();
  evaluation.formulas = static_cast<IndexFormulas>(2);
  CHECK(has_text(test::bytes_back(write, read), "formulas are unknown"));
}

TEST_CASE("noise_law_bytes__bring_back_the_same_law") {
  NoiseLaw law = noise_law_from_json(R"({"law": "empirical", "quantiles": [-0.1, 0.1, 0.3]})"),
           back;
  CHECK(test::bytes_back([&](ByteWriter& w) { write_noise_law(w, law); },
                         [&](ByteReader& r, Task&) { back = read_noise_law(r); }) == "");
  CHECK(back.quantiles == law.quantiles);
  CHECK(has_text(test::bytes_back([](ByteWriter& w) { w.text("{\"law\": \"none\"}"); },
                                  [](ByteReader& r, Task&) { read_noise_law(r); }),
                 "no noise law"));
}

}  // namespace
}  // namespace jalon
