// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/inputs/polygon_input.h"
#include "cli/output_check.h"

namespace jalon::cli {

namespace {

struct Cut {
  Common common;
  Input input;
  std::string output, polygon, polygon_file;
  // Along the plane's normal, in metres; NaN: without end.
  double from_m = std::numeric_limits<double>::quiet_NaN(),
         to_m = std::numeric_limits<double>::quiet_NaN();
  bool outside = false;

  CutPolygon corners() const {
    if (polygon.empty() == polygon_file.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "a cut needs its polygon, by --polygon or by --polygon-file"};
    CutPolygon out = polygon.empty() ? read_cut_polygon(polygon_file) : parse_cut_polygon(polygon);
    if (from_m > to_m)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--from lies above --to: nothing is between"};
    return out;
  }

  void run() const {
    Console console(common);
    const CutPolygon cut = corners();  // what is wrong with it is told before a long read
    check_output_file(output);
    console.step("reading");
    const Cloud cloud = input.read(console);
    console.step("cutting");
    const double low = std::isnan(from_m) ? -INFINITY : from_m,
                 high = std::isnan(to_m) ? INFINITY : to_m;
    Cloud inside, rest;
    must(jalon_cloud_crop_polygon(cloud.get(), cut.uv.data(), cut.uv.size() / 2, low, high,
                                  &cut.T_prism_world, console.task(), Out(inside), Out(rest)));
    const Cloud& kept = outside ? rest : inside;
    if (count_of(kept) == 0)
      throw Failure{JALON_ERROR_DEGENERATE,
                    input.path + ": no point lies " + (outside ? "outside" : "in") +
                        " the cut, nothing written; \"jalon info\" tells where the points are"};
    console.step("writing");
    must(jalon_cloud_write(kept.get(), output.c_str(), nullptr, console.task()));
    console.say(grouped(count_of(kept)) + " of " + grouped(count_of(cloud)) +
                " points: " + input.path + " -> " + output);
    console.result({{"input", input.path},
                    {"output", output},
                    {"points_in", count_of(cloud)},
                    {"points", count_of(kept)}});
  }
};

}  // namespace

void add_cut(Command& app) {
  Command command =
      app.subcommand("cut", "Keeps what lies in a polygon, in plan or in any plane, and writes it");
  auto state = std::make_shared<Cut>();
  state->input.add_to(command);
  command.option("-o,--output", state->output, "File to write: .las, .ply, .xyz, .txt, .csv")
      .required()
      .type_name("OUTPUT");
  command
      .option("--polygon", state->polygon,
              "Corners: X,Y each in plan, X,Y,Z each in the plane that they lie in")
      .type_name("CORNER;CORNER;...");
  command
      .option("--polygon-file", state->polygon_file,
              "The same from a file, a corner a line: x y, or x y z")
      .type_name("FILE");
  command.option("--from", state->from_m,
                 "Lowest height kept (m): z in plan, else before the plane, on the side that sees "
                 "the corners run anticlockwise; default: no end");
  command.option("--to", state->to_m, "Highest height kept (m); default: no end");
  command.flag("--outside", state->outside, "Keep what lies outside instead");
  add_common(command, state->common);
  command.footer(
      "Examples:\n  jalon cut scan.las -o yard.las --polygon \"0,0; 20,0; 20,8; 0,8\" --from 0.2\n"
      "  jalon cut scan.las -o facade.las --polygon \"0,0,0; 9,0,0; 9,0,6; 0,0,6\" --from -0.5 "
      "--to 0.5\n"
      "  jalon cut scan.las -o rest.las --polygon-file tree.txt --outside");
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
