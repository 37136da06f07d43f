// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/comparing/field_steps.h"

#include <algorithm>

#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

/// One step as it was asked for: words that are no parameters of its operation, and its parameters.
struct FieldStep {
  std::string operation, field = "distance", gradient_field = "gradient", other;
  std::vector<uint64_t> seeds;
  Params params;
};

/// What the steps share: the last law is that of the next test.
struct FieldState {
  const Console& console;
  const Cloud &cloud, &reference;
  NoiseLaw law;
};

Json rows_of(Fields fields) { return Table(std::move(fields)).list(); }

Json fit_law(FieldState& state, const FieldStep& step) {
  must(jalon_noise_law_fit(state.cloud.get(), step.field.c_str(), step.params.get(),
                           state.console.task(), Out(state.law)));
  const char* text = nullptr;
  must(jalon_noise_law_json(state.law.get(), &text));
  return {{"law", Json::parse(text)}};
}

Json test_chi_square(FieldState& state, const FieldStep& step) {
  if (state.law == nullptr)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                  "--then chi_square needs a law: --then noise_law before it fits one"};
  Fields summary;
  must(jalon_cloud_compute_chi_square(state.cloud.get(), step.field.c_str(), state.law.get(),
                                      step.params.get(), state.console.task(), Out(summary)));
  return {{"summary", rows_of(std::move(summary))[0]}};
}

Json classify(FieldState& state, const FieldStep& step) {
  Fields summary;
  must(jalon_cloud_classify_field(state.cloud.get(), step.field.c_str(), step.params.get(),
                                  state.console.task(), Out(summary)));
  return {{"summary", rows_of(std::move(summary))[0]}};
}

Json take_gradient(FieldState& state, const FieldStep& step) {
  must(jalon_cloud_compute_gradient(state.cloud.get(), step.field.c_str(), step.params.get(),
                                    state.console.task()));
  return Json::object();
}

Json filter(FieldState& state, const FieldStep& step) {
  must(jalon_cloud_filter_field(state.cloud.get(), step.field.c_str(), step.params.get(),
                                state.console.task()));
  return Json::object();
}

Json compute(FieldState& state, const FieldStep& step) {
  must(jalon_cloud_compute_field(state.cloud.get(), step.field.c_str(),
                                 step.other.empty() ? nullptr : step.other.c_str(),
                                 step.params.get(), state.console.task()));
  return Json::object();
}

Json propagate(FieldState& state, const FieldStep& step) {
  Fields regions;
  must(jalon_cloud_segment_propagation(state.cloud.get(), step.field.c_str(),
                                       step.gradient_field.c_str(), step.params.get(),
                                       state.console.task(), Out(regions)));
  return {{"regions", rows_of(std::move(regions))}};
}

Json march(FieldState& state, const FieldStep& step) {
  must(jalon_cloud_compute_geodesic(state.cloud.get(), step.seeds.data(), step.seeds.size(),
                                    step.params.get(), state.console.task()));
  return Json::object();
}

Json map_distance(FieldState& state, const FieldStep& step) {
  if (state.reference == nullptr)
    throw Failure{JALON_ERROR_UNSUPPORTED,
                  "--then distance_map needs a scan on the reference side, not a model"};
  must(jalon_cloud_compute_map_distance(state.cloud.get(), state.reference.get(), step.params.get(),
                                        state.console.task()));
  return Json::object();
}

Json count(FieldState& state, const FieldStep& step) {
  Fields bins, summary;
  must(jalon_cloud_field_histogram(state.cloud.get(), step.field.c_str(), state.law.get(),
                                   step.params.get(), state.console.task(), Out(bins),
                                   Out(summary)));
  return {{"summary", rows_of(std::move(summary))[0]}, {"bins", rows_of(std::move(bins))}};
}

Json test_normality(FieldState& state, const FieldStep& step) {
  Fields summary;
  must(jalon_cloud_field_normality(state.cloud.get(), step.field.c_str(), step.params.get(),
                                   state.console.task(), Out(summary)));
  return {{"summary", rows_of(std::move(summary))[0]}};
}

struct FieldOperation {
  const char* name;
  const char* words;  ///< beside its parameters
  Json (*run)(FieldState& state, const FieldStep& step);
};
constexpr FieldOperation kFieldOperations[] = {{"classes", "field", classify},
                                               {"noise_law", "field", fit_law},
                                               {"chi_square", "field", test_chi_square},
                                               {"histogram", "field", count},
                                               {"normality", "field", test_normality},
                                               {"gradient", "field", take_gradient},
                                               {"field_filter", "field", filter},
                                               {"field_arithmetic", "field other", compute},
                                               {"propagation", "field gradient_field", propagate},
                                               {"geodesic", "seeds", march},
                                               {"distance_map", "", map_distance}};

Failure wrong_step(const std::string& why) { return {JALON_ERROR_INVALID_ARGUMENT, why}; }

const FieldOperation& operation_of(const std::string& name) {
  std::string names;
  for (const FieldOperation& one : kFieldOperations) {
    if (name == one.name) return one;
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  throw wrong_step("--then knows no operation \"" + name + "\"; there are: " + names);
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c != ' ') out.back() += c;
    else if (!out.back().empty()) out.emplace_back();
  }
  if (out.back().empty()) out.pop_back();
  return out;
}

bool takes(const FieldOperation& operation, const std::string& word) {
  const std::vector<std::string> words = words_of(operation.words);
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<uint64_t> indices_of(const std::string& text) {
  size_t end = 0;
  std::vector<uint64_t> out;
  for (const double index : leading_numbers(text, end)) {
    constexpr double kMost = 9007199254740992;  // whole numbers up to 2^53
    if (!(index >= 0) || index > kMost ||
        index != static_cast<double>(static_cast<uint64_t>(index)))
      throw wrong_step("--then geodesic: seeds are numbers of points, from 0 on");
    out.push_back(static_cast<uint64_t>(index));
  }
  if (end != text.size()) throw wrong_step("--then geodesic: seeds are numbers, as seeds=0,17");
  return out;
}

FieldStep step_of(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  if (words.empty()) throw wrong_step("--then needs an operation");
  const FieldOperation& operation = operation_of(words[0]);
  FieldStep out;
  out.operation = words[0];
  out.params = make_params(operation.name);
  for (size_t k = 1; k < words.size(); ++k) {
    const size_t equal = words[k].find('=');
    const std::string name = words[k].substr(0, equal);
    const std::string value = equal == std::string::npos ? "" : words[k].substr(equal + 1);
    if (!takes(operation, name)) assign(out.params.get(), "--then " + words[0], words[k]);
    else if (name == "seeds") out.seeds = indices_of(value);
    else (name == "field" ? out.field : name == "other" ? out.other : out.gradient_field) = value;
  }
  return out;
}

}  // namespace

void FieldSteps::add_to(Command& command) {
  command
      .option("--then", texts_,
              "What to do with the distances, one after the other, e.g. --then \"gradient "
              "radius_m=0.3\" (repeatable); the tables below tell what there is")
      .type_name("OPERATION")
      .one_each_time();
}

void FieldSteps::check() const {
  for (const std::string& text : texts_) step_of(text);
}

Json FieldSteps::run(const Console& console, const Cloud& cloud, const Cloud& reference) const {
  FieldState state{console, cloud, reference, nullptr};
  Json out = Json::array();
  for (const std::string& text : texts_) {
    const FieldStep step = step_of(text);
    Json one{{"operation", step.operation}, {"parameters", json_of(step.params.get())}};
    one.update(operation_of(step.operation).run(state, step));
    out.push_back(std::move(one));
  }
  return out;
}

std::string FieldSteps::tables() {
  std::string out;
  for (const FieldOperation& one : kFieldOperations) {
    out += "Parameters of --then " + std::string(one.name);
    const std::vector<std::string> words = words_of(one.words);
    for (size_t k = 0; k < words.size(); ++k)
      out += (k == 0 ? ", besides " : " and ") + words[k] +
             (words[k] == "field"            ? "=NAME (distance)"
              : words[k] == "gradient_field" ? "=NAME (gradient)"
              : words[k] == "other"          ? "=NAME (none: the parameter constant)"
                                             : "=POINTS, where fronts begin");
    out += ":\n" + describe(make_params(one.name).get()) + "\n";
  }
  return out;
}

}  // namespace jalon::cli
