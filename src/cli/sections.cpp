// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

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

constexpr uint64_t kMostSectionsListed = 20;

struct SectionJob {
  Common common;
  Input input;
  Settings settings, write_settings;
  std::string output, heights, stations, direction, alignment;
  double every_m = 0;

  static std::vector<double> numbers(const std::string& text, const char* option) {
    size_t end = 0;
    std::vector<double> out = leading_numbers(text, end);
    if (end != text.size() || out.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    std::string(option) + ": \"" + text + "\" are no numbers parted by commas"};
    return out;
  }

  // Points of the axis, three numbers each; a third one in the file has no say.
  std::vector<double> axis() const {
    std::vector<double> out;
    if (alignment.empty()) return out;
    for (const NumberLine& line : read_number_lines(alignment)) {
      if (line.numbers.empty()) continue;
      if (line.numbers.size() != 2 && line.numbers.size() != 3)
        throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                      alignment + ": every point needs two numbers (x y) or three (x y z)"};
      out.insert(out.end(), {line.numbers[0], line.numbers[1], 0});
    }
    if (out.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, alignment + ": no points of an alignment"};
    return out;
  }

  Params cuts() const {
    if (!alignment.empty() && (!heights.empty() || !direction.empty()))
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "an alignment is cut at --stations or --every; it has no --heights and no "
                    "--direction"};
    if (alignment.empty() && !stations.empty() && direction.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--stations need an --alignment"};
    Params params = make_params("sections");
    const auto set = [&](const char* name, const std::vector<double>& values) {
      must(jalon_params_set_doubles(params.get(), name, values.data(), values.size()));
    };
    if (!direction.empty()) set("direction", numbers(direction, "--direction"));
    if (!heights.empty()) set("at_m", numbers(heights, "--heights"));
    if (!stations.empty()) set("at_m", numbers(stations, "--stations"));
    if (every_m > 0) must(jalon_params_set_double(params.get(), "step_m", every_m));
    settings.apply(params.get());
    return params;
  }

  using Sections = std::unique_ptr<jalon_sections, Release<jalon_sections_release>>;

  static Table table(const Sections& sections,
                     jalon_status (*get)(const jalon_sections*, jalon_fields**)) {
    Fields fields;
    must(get(sections.get(), Out(fields)));
    return Table(std::move(fields));
  }

  static Json named(const Sections& sections, const Table& summary) {
    Json rows = Json::array();
    for (uint64_t s = 0; s < summary.rows(); ++s) {
      const char* name = nullptr;
      must(jalon_sections_name(sections.get(), s, &name));
      Json row{{"name", name}};
      row.update(summary.object(s));
      rows.push_back(std::move(row));
    }
    return rows;
  }

  static void say(const Console& console, const Json& rows, const Lengths& lengths) {
    for (uint64_t s = 0; s < rows.size() && s < kMostSectionsListed; ++s) {
      const Json& row = rows[s];
      console.say(
          row["name"].get<std::string>() + ": " + row["lines"].dump() +
          (row["lines"] == 1 ? " line, " : " lines, ") + fixed(row["length"].get<double>(), 2) +
          " " + lengths.length() + ", " + grouped(row["points"].get<uint64_t>()) + " points" +
          (std::isnan(row["rms"].get<double>())
               ? ""
               : ", rms " + lengths.fine(row["rms"].get<double>(), 1) + " " + lengths.fine()));
    }
    if (rows.size() > kMostSectionsListed)
      console.say("... " + grouped(rows.size()) + " sections in sections.csv");
  }

  void run() const {
    Console console(common);
    check_output_folder(output);
    const Params params = cuts(), write = make_params("write");
    write_settings.apply(write.get());
    const std::vector<double> points = axis();
    console.step("reading");
    const Cloud cloud = input.read(console);
    console.step("cutting");
    Sections sections;
    must(jalon_cloud_sections(cloud.get(), points.data(), points.size() / 3, params.get(),
                              console.task(), Out(sections)));
    const Table lines = table(sections, jalon_sections_lines);
    if (lines.rows() == 0)
      found_nothing(input, cloud, "no line in any section",
                    "--set thickness_m, gap_m and min_length_m; places are in the scan's own "
                    "coordinates");
    const Json rows = named(sections, table(sections, jalon_sections_summary));
    const char* parameters = nullptr;
    must(jalon_sections_parameters(sections.get(), &parameters));
    Json result{{"input", input.path},
                {"alignment", alignment},
                {"output", output},
                {"sections", rows},
                {"lines", lines.list()},
                {"vertices", table(sections, jalon_sections_vertices).list()},
                {"parameters", Json::parse(parameters)}};
    console.step("writing");
    OutputFolder folder(output);
    for (const char* name : {"sections.dxf", "sections.svg"})
      must(jalon_sections_write(sections.get(), folder.path(name).c_str(), write.get(),
                                console.task()));
    write_text_file(folder.path("sections.csv"), csv_of(rows));
    write_text_file(folder.path("lines.csv"), lines.csv());
    write_text_file(folder.path("sections.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    folder.commit();
    say(console, rows, Lengths::of(input, cloud));
    console.say("wrote " + output +
                ": sections.dxf, sections.svg, sections.csv, lines.csv, sections.json");
    console.result(result);
  }
};

}  // namespace

void add_sections(Command& app) {
  Command command = app.subcommand(
      "sections", "Sections of a scan as drawings: at heights, along a direction or an alignment");
  auto state = std::make_shared<SectionJob>();
  state->input.add_to(command);
  add_output_folder(command, state->output);
  command.option("--heights", state->heights, "Level sections at these heights (m)")
      .type_name("Z,Z,...");
  command
      .option("--direction", state->direction,
              "Sections across this direction instead; --heights are then places along it")
      .type_name("X,Y,Z");
  command
      .option("--alignment", state->alignment,
              "File with the points of an axis, a line each (x y): cross-sections along it")
      .type_name("FILE");
  command.option("--stations", state->stations, "Stations of the alignment (m) to cut at")
      .type_name("S,S,...");
  command
      .option("--every", state->every_m,
              "Cut at all multiples of this (m), of heights, places or stations; default: of 1 m")
      .positive();
  state->settings.add_to(command);
  state->write_settings.add_to(command, "write-");
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("sections").get()) +
           R"(
sections.dxf has a layer a section, named by its height or station, where it is in space; sections.svg
draws level sections as one plan and others side by side, to scale. sections.csv counts points and
tells the rms of their distances from the lines.

Examples:
  jalon sections floor.las -o plans --heights 1.0,2.0
  jalon sections tunnel.laz -o profiles --alignment axis.txt --every 5 --set reach_m=8
  jalon sections hall.e57 -o cuts --direction 1,0,0 --every 2 --write-set dxf_version=r12)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
