// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/evaluate_tables.h"

#include <nlohmann/json.hpp>

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kEvaluateTablesDegrees = 57.29577951308232;
constexpr size_t kListed = 20;  // labels of an unmatched list shown to people

Table table_of(const jalon_evaluation* evaluation,
               jalon_status (*get)(const jalon_evaluation*, jalon_fields**)) {
  Fields fields;
  must(get(evaluation, Out(fields)));
  return Table(std::move(fields));
}

std::string right_of_evaluate_tables(const std::string& text, size_t width) {
  return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

constexpr const char* kCounts[] = {"card_automatic", "card_reference", "intersection", "commission",
                                   "omission"};

// A number of a table: a count without decimals (-1), a rate or a length with them.
std::string cell(const Table& table, const char* name, uint64_t row, size_t width, int decimals,
                 double scale = 1) {
  if (decimals < 0) return right_of_evaluate_tables(grouped(table.count(name, row)), width);
  return right_of_evaluate_tables(fixed(scale * table.number(name, row), decimals), width);
}

// Labels of the kept segments without a pair.
std::vector<int64_t> unmatched(const Table& side) {
  std::vector<int64_t> out;
  for (uint64_t i = 0; i < side.rows(); ++i)
    if (side.count("kept", i) != 0 && side.count("partner", i) == 0)
      out.push_back(static_cast<int64_t>(side.number("source_label", i)));
  return out;
}

std::string listed(const std::vector<int64_t>& labels) {
  std::string text;
  for (size_t i = 0; i < std::min(labels.size(), kListed); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(labels[i]);
  return labels.size() > kListed ? text + " ..." : text;
}

}  // namespace

EvaluationTables::EvaluationTables(const jalon_evaluation* evaluation)
    : pairs(table_of(evaluation, jalon_evaluation_pairs)),
      automatic(table_of(evaluation, jalon_evaluation_automatic)),
      reference(table_of(evaluation, jalon_evaluation_reference)),
      totals(table_of(evaluation, jalon_evaluation_totals)) {}

void EvaluationTables::print(const Console& console, const Lengths& lengths) const {
  const double scale = lengths.is_known() ? 1000 : 1;
  const int decimals = lengths.is_known() ? 2 : 5;
  // Segments go by the numbers they have in the files.
  const auto source = [](const Table& side, uint64_t label) {
    return right_of_evaluate_tables(
        std::to_string(static_cast<int64_t>(side.number("source_label", label - 1))), 10);
  };
  console.say(
      " reference  automatic     Card A    Card SR          I         D+         D-    TDR    TDA  "
      "  IoU  angle deg" +
      lengths.heading("D", "mm", 8) + lengths.heading("offset", "mm", 11));
  for (uint64_t i = 0; i < pairs.rows(); ++i) {
    std::string line = source(reference, pairs.count("reference", i)) + " ";
    line += source(automatic, pairs.count("automatic", i));
    for (const char* name : kCounts) line += cell(pairs, name, i, 11, -1);
    for (const char* name : {"tdr", "tda", "iou"}) line += cell(pairs, name, i, 7, 3);
    console.say(line + cell(pairs, "angle", i, 11, 4, kEvaluateTablesDegrees) +
                cell(pairs, "distance", i, 8, decimals, scale) +
                cell(pairs, "offset_difference", i, 11, decimals, scale));
  }
  std::string sums = right_of_evaluate_tables("total", 21),
              means = right_of_evaluate_tables("mean", 76),
              deviations = right_of_evaluate_tables("deviation", 76);
  for (const char* name : kCounts) sums += cell(totals, name, 0, 11, -1);
  for (const char* name : {"global_tdr", "global_tda", "global_iou"})
    sums += cell(totals, name, 0, 7, 3);
  for (const char* name : {"mean_tdr", "mean_tda", "mean_iou"})
    means += cell(totals, name, 0, 7, 3);
  console.say(sums);
  console.say(means + cell(totals, "mean_angle", 0, 11, 4, kEvaluateTablesDegrees) +
              cell(totals, "mean_distance", 0, 8, decimals, scale) +
              cell(totals, "mean_offset_difference", 0, 11, decimals, scale));
  console.say(deviations + std::string(21, ' ') +
              cell(totals, "std_angle", 0, 11, 4, kEvaluateTablesDegrees) +
              cell(totals, "std_distance", 0, 8, decimals, scale) +
              cell(totals, "std_offset_difference", 0, 11, decimals, scale));
  print_errors(console);
}

// Counts of what went wrong, and the lists that the table of pairs lacks.
void EvaluationTables::print_errors(const Console& console) const {
  const auto count = [&](const char* name) { return grouped(totals.count(name, 0)); };
  console.say("pairs " + count("pairs") + "; over-segmented " + count("over_segmented") +
              ", under-segmented " + count("under_segmented") + ", non-segmented " +
              count("non_segmented") + "; left out as too small: " + count("left_out_reference") +
              " reference, " + count("left_out_automatic") + " automatic");
  const auto lonely = [&](const char* which, const Table& side) {
    const auto labels = unmatched(side);
    if (!labels.empty())
      console.say("unmatched " + std::string(which) + " (" + grouped(labels.size()) +
                  "): " + listed(labels));
  };
  lonely("reference", reference);
  lonely("automatic", automatic);
  const auto rate = [&](const char* name) { return fixed(totals.number(name, 0), 4); };
  console.say("detection " + rate("detection") + ", accuracy " + rate("accuracy") +
              " (mean TDR and TDA with unmatched segments as 0)");
}

Json EvaluationTables::json() const {
  return {{"totals", totals.object(0)},
          {"pairs", pairs.list()},
          {"automatic", automatic.list()},
          {"reference", reference.list()},
          {"unmatched_automatic", unmatched(automatic)},
          {"unmatched_reference", unmatched(reference)}};
}

void ConfusionTables::print(const Console& console) const {
  const auto number = [&](const char* name, uint64_t i) {
    return right_of_evaluate_tables(fixed(classes.number(name, i), 4), 10);
  };
  const auto class_name = [&](uint64_t i) {
    return std::to_string(static_cast<int64_t>(classes.number("class", i)));
  };
  console.say("confusion matrix: a row a reference class, a column a class given");
  std::string heading = right_of_evaluate_tables("class", 10);
  for (uint64_t i = 0; i < classes.rows(); ++i)
    heading += right_of_evaluate_tables(class_name(i), 11);
  console.say(heading + right_of_evaluate_tables("points", 11) +
              right_of_evaluate_tables("precision", 10) + right_of_evaluate_tables("recall", 10) +
              right_of_evaluate_tables("F1", 10));
  for (uint64_t i = 0; i < classes.rows(); ++i) {
    std::string line = right_of_evaluate_tables(class_name(i), 10);
    for (uint32_t k = 0; k < classes.rows(); ++k)
      line += right_of_evaluate_tables(
          grouped(static_cast<uint64_t>(classes.number("confusion", i, k))), 11);
    console.say(line + right_of_evaluate_tables(grouped(classes.count("reference", i)), 11) +
                number("precision", i) + number("recall", i) + number("f1", i));
  }
  const auto total = [&](const char* name) { return fixed(totals.number(name, 0), 4); };
  console.say("overall accuracy " + total("accuracy") + ", mean precision " +
              total("mean_precision") + ", mean recall " + total("mean_recall") + ", mean F1 " +
              total("mean_f1") + ", kappa " + total("kappa"));
}

Json ConfusionTables::json() const {
  return {{"totals", totals.object(0)}, {"classes", classes.list()}};
}

}  // namespace jalon::cli
