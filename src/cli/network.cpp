// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/lengths.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/outputs/json_csv.h"
#include "cli/table.h"
#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMm_per_m = 1e3;
constexpr size_t kMostOutliersListed = 10;

const char* kind_name(uint64_t kind) {
  static constexpr const char* kNames[] = {"direction", "zenith", "distance", "x",
                                           "y",         "z",      "centring", "height"};
  return kNames[kind - 1];
}

struct NetworkJob {
  Common common;
  Settings settings;
  std::string observations, points, output;

  Network adjusted(const Console& console, const Params& params) const {
    const std::string sights = read_text_file(observations);
    const std::string places = points.empty() ? "" : read_text_file(points);
    Network made;
    must_read(jalon_network_adjust(sights.c_str(), places.c_str(), params.get(), console.task(),
                                   Out(made)));
    return made;
  }

  static std::string name(const Network& network, uint64_t point) {
    const char* text = nullptr;
    must(jalon_network_point_name(network.get(), point, &text));
    return text;
  }

  // The rows with the names of their points in the place of numbers.
  static Json named_points(const Network& network, const Table& table) {
    Json list = Json::array();
    for (uint64_t i = 0; i < table.rows(); ++i) {
      Json row{{"id", name(network, i)}};
      row.update(table.object(i));
      list.push_back(std::move(row));
    }
    return list;
  }
  static Json named_observations(const Network& network, const Table& table) {
    Json list = Json::array();
    for (uint64_t i = 0; i < table.rows(); ++i) {
      Json row = table.object(i);
      row["kind"] = kind_name(table.count("kind", i));
      for (const char* end : {"from", "to"}) row[end] = name(network, table.count(end, i));
      list.push_back(std::move(row));
    }
    return list;
  }

  static void say(const Console& console, const Json& summary, const Json& rows,
                  const Table& points) {
    double most = 0;
    for (uint64_t i = 0; i < points.rows(); ++i)
      for (uint32_t axis = 0; axis < 3; ++axis)
        most = std::max(most, points.number("sigma", i, axis));
    console.say(summary["points"].dump() + " points, " + summary["setups"].dump() + " setups, " +
                summary["observations"].dump() + " observations, " + summary["redundancy"].dump() +
                " to spare");
    console.say("largest standard deviation of a coordinate " + fixed(most * kMm_per_m, 1) +
                " mm, global test p = " + fixed(summary["p_value"].get<double>(), 3));
    if (summary["converged"] == 0) console.warn("the adjustment has not converged");
    std::vector<const Json*> outliers;
    for (const Json& row : rows)
      if (row["outlier"] == 1) outliers.push_back(&row);
    const auto size = [](const Json* row) { return std::abs((*row)["normalised"].get<double>()); };
    std::stable_sort(outliers.begin(), outliers.end(),
                     [&](const Json* a, const Json* b) { return size(a) > size(b); });
    for (size_t i = 0; i < std::min(outliers.size(), kMostOutliersListed); ++i)
      console.say("outlier: " + told(*outliers[i]));
    if (outliers.size() > kMostOutliersListed)
      console.say("... " + grouped(outliers.size()) + " outliers in observations.csv");
  }

  static std::string told(const Json& row) {
    const auto text = [&](const char* name) { return row[name].get<std::string>(); };
    const bool has_line = row["line"] != 0;
    return text("kind") +
           (text("from") == text("to") ? " of " + text("from")
                                       : " from " + text("from") + " to " + text("to")) +
           (has_line ? ", line " + row["line"].dump() : "") +
           ", w = " + fixed(row["normalised"].get<double>(), 1) +
           (row["rejected"] == 1 ? ", left out" : "");
  }

  void run() const {
    Console console(common);
    check_output_folder(output);
    const Params params = make_params("network");
    settings.apply(params.get());
    console.step("adjusting");
    const Network network = adjusted(console, params);
    const auto table = [&](jalon_status (*get)(const jalon_network*, jalon_fields**)) {
      Fields fields;
      must(get(network.get(), Out(fields)));
      return Table(std::move(fields));
    };
    const Table point_table = table(jalon_network_points);
    const Json summary = table(jalon_network_summary).object(0);
    const Json places = named_points(network, point_table);
    const Json sights = named_observations(network, table(jalon_network_observations));
    const char *codes = nullptr, *parameters = nullptr;
    must(jalon_network_codes(network.get(), &codes));
    must(jalon_network_parameters(network.get(), &parameters));
    Json result{{"observations_file", observations},
                {"points_file", points},
                {"output", output},
                {"summary", summary},
                {"points", places},
                {"observations", sights},
                {"parameters", Json::parse(parameters)}};
    OutputFolder folder(output);
    write_text_file(folder.path("points.csv"), csv_of(places));
    write_text_file(folder.path("observations.csv"), csv_of(sights));
    write_text_file(folder.path("codes.txt"), codes);
    write_text_file(folder.path("network.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    const Json notes{{"title", "Total-station network"},
                     {"input", {{"observations", observations}, {"points", points}}}};
    for (const char* file : {"report.html", "plan.svg"})
      must(jalon_report_write_network(
          network.get(), notes.dump(-1, ' ', false, Json::error_handler_t::replace).c_str(),
          folder.path(file).c_str(), console.task()));
    folder.commit();
    say(console, summary, sights, point_table);
    console.say("wrote " + output +
                ": report.html, plan.svg, points.csv, observations.csv, codes.txt, network.json");
    console.result(result);
  }
};

}  // namespace

void add_network(Command& app) {
  Command command = app.subcommand(
      "network", "A total-station network by least squares: stations and coded points");
  auto state = std::make_shared<NetworkJob>();
  command
      .option("observations", state->observations,
              "Sights: columns from, to, direction, zenith, distance, instrument_height ...")
      .required()
      .type_name("OBSERVATIONS");
  command
      .option("--points", state->points,
              "Fixed, weak and approximate points: columns id, x, y, z, sx, sy, sz, code")
      .type_name("FILE");
  add_output_folder(command, state->output);
  state->settings.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("network").get()) +
           R"(
The first line of either file names its columns; cells are parted by ; , tabs or blanks, and - is what
is not known. Angles are gon unless angle_unit says otherwise; a standard deviation of 0 fixes a
coordinate. Points that are only sighted need no line. codes.txt goes straight into jalon code.

Examples:
  jalon network sights.txt --points nails.txt -o survey
  jalon network sights.txt --points nails.txt -o survey --set reject=true
  jalon network sights.txt -o shape --set datum=free)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
