// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/outputs/json_csv.h"
#include "cli/table.h"
#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPlaceDecimals = 4;  // tenths of a millimetre
constexpr double kMm = 1e3;
constexpr size_t kMostTargetsListed = 20;  // on the screen; all of them stand in targets.csv

const char* verdict_name(uint64_t verdict) {
  switch (verdict) {
    case JALON_RECOGNISED_KNOWN:
      return "known";
    case JALON_RECOGNISED_AMBIGUOUS:
      return "ambiguous";
    case JALON_RECOGNISED_FOREIGN:
      return "foreign";
    default:
      return "uncertain";
  }
}

/// The catalogue as the library has read it: the entry of a row.
std::string entry_text(const Json& catalogue, double entry, const char* what) {
  if (entry < 0) return "";
  const Json& row = catalogue["targets"][static_cast<size_t>(entry)];
  if (!row.contains(what)) return "";
  return row[what].is_string() ? row[what].get<std::string>() : row[what].dump();
}

/// Rows of targets.csv.
Json rows_of(const Table& table, const Json& catalogue) {
  Json out = Json::array();
  for (uint64_t i = 0; i < table.rows(); ++i) {
    const double entry = table.number("entry", i), second = table.number("second", i);
    const bool is_known = table.count("verdict", i) == JALON_RECOGNISED_KNOWN;
    Json row{{"id", "T" + std::to_string(i + 1)}};
    for (uint32_t k = 0; k < 3; ++k)
      row[std::string(1, "xyz"[k])] = table.number("centre", i, k);
    for (uint32_t k = 0; k < 3; ++k)
      row[std::string("sigma_") + "xyz"[k] + "_m"] =
          std::sqrt(table.number("covariance", i, 4 * k));
    row["kind"] = table.count("kind", i) == JALON_TARGET_CHECKER ? "checker" : "disc";
    row["size_m"] = table.number("size", i);
    row["size_sigma_m"] = table.number("size_sigma", i);
    row["verdict"] = verdict_name(table.count("verdict", i));
    row["code"] = is_known ? entry_text(catalogue, entry, "code") : "";
    row["name"] = is_known ? entry_text(catalogue, entry, "name") : "";
    row["confidence"] = table.number("confidence", i);
    row["may_be"] = is_known ? "" : entry_text(catalogue, entry, "code");
    row["or"] = entry_text(catalogue, second, "code");
    row["target_confidence"] = table.number("pattern_confidence", i);
    row["points"] = table.count("points", i);
    out.push_back(std::move(row));
  }
  return out;
}

/// Those with a code as "jalon code --method targets" reads them.
std::string code_lines(const Json& rows) {
  std::string out;
  for (const Json& row : rows) {
    if (row["verdict"] != "known") continue;
    out += row["id"].get<std::string>();
    for (const char* axis : {"x", "y", "z"})
      out += ";" + fixed(row[axis].get<double>(), kPlaceDecimals);
    out += ";" + row["code"].get<std::string>() + "\n";
  }
  return out;
}

std::string told(const Json& row) {
  const bool is_known = row["verdict"] == "known";
  const auto text = [&](const char* name) { return row[name].get<std::string>(); };
  const std::string maybe = is_known || text("may_be").empty() ? "" : ", perhaps " + text("may_be"),
                    other = text("or").empty() ? "" : " or " + text("or");
  return text("id") + ": " + text("kind") + " of " + fixed(row["size_m"].get<double>() * kMm, 0) +
         " mm, " + (is_known ? "code " + text("code") : text("verdict")) + maybe + other +
         ", confidence " + fixed(row["confidence"].get<double>(), 2);
}

struct TargetsJob {
  Common common;
  Input input;
  Settings settings;
  std::string catalogue, output;

  void run() const {
    Console console(common);
    check_output_folder(output);
    const Params params = make_params("target");
    settings.apply(params.get());
    const std::string text = read_text_file(catalogue);
    must(jalon_params_set_string(params.get(), "catalogue", text.c_str()));
    console.step("reading");
    const Cloud cloud = input.read(console);
    console.step("targets");
    Fields fields;
    must(jalon_cloud_measure_targets(cloud.get(), nullptr, 0, params.get(), console.task(),
                                     Out(fields)));
    const Table table(std::move(fields));
    if (table.rows() == 0)
      throw Failure{JALON_ERROR_INSUFFICIENT_DATA,
                    input.path + ": no target of these kinds and sizes shows in the intensities"};
    const Json rows = rows_of(table, Json::parse(text));
    Json counts{{"known", 0}, {"ambiguous", 0}, {"foreign", 0}, {"uncertain", 0}};
    for (const Json& row : rows) {
      Json& count = counts[row["verdict"].get<std::string>()];
      count = count.get<int>() + 1;
    }
    const Json result{{"input", input.path}, {"catalogue", catalogue}, {"output", output},
                      {"counts", counts},    {"targets", rows}};
    OutputFolder folder(output);
    write_text_file(folder.path("targets.csv"), csv_of(rows));
    write_text_file(folder.path("targets.txt"), code_lines(rows));
    write_text_file(folder.path("targets.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    folder.commit();
    for (size_t i = 0; i < std::min<size_t>(rows.size(), kMostTargetsListed); ++i)
      console.say(told(rows[i]));
    if (rows.size() > kMostTargetsListed)
      console.say("... " + grouped(rows.size()) + " targets in targets.csv");
    console.say(counts["known"].dump() + " with a code, " + counts["ambiguous"].dump() +
                " ambiguous, " + counts["foreign"].dump() + " in no entry, " +
                counts["uncertain"].dump() + " uncertain");
    console.say("wrote " + output + ": targets.txt, targets.csv, targets.json");
    console.result(result);
  }
};

}  // namespace

void add_targets(Command& app) {
  Command command = app.subcommand(
      "targets", "Flat targets of a whole scan by their brightness, with the codes of their kinds");
  auto state = std::make_shared<TargetsJob>();
  state->input.add_to(command);
  command
      .option("catalogue", state->catalogue,
              "Targets that were put up (JSON): kind, size and code of each")
      .required()
      .type_name("CATALOGUE");
  command.option("-o,--output", state->output, "Folder for the results")
      .required()
      .type_name("DIR");
  state->settings.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("target").get()) +
           R"(
The catalogue names what was put up, e.g. checkers (four quadrants; size: the edge) and discs (size: the
diameter):
  {"targets": [{"code": "1", "name": "wall", "kind": "checker", "size_m": 0.15},
               {"code": "2", "name": "door", "kind": "checker", "size_m": 0.10},
               {"code": "3", "name": "window", "kind": "disc", "size_m": 0.10}]}

targets.txt has those with a code as ID;X;Y;Z;code, facade by facade, for jalon code --method targets.
targets.csv has all: centre with its standard deviations, kind, size, confidence. No code stands where two
entries or readings fit (ambiguous), where none does (foreign), or below the confidence asked for
(uncertain). The scan needs intensities.

Examples:
  jalon targets scan.las catalogue.json -o found
  jalon targets scan.las catalogue.json -o found --set confidence=0.97
  jalon code scan.las found/targets.txt -o result --method targets)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
