// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

#include "cli/inputs/clearance_inputs.h"
#include "cli/lengths.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/outputs/clearance_drawing.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string lower_end(const std::string& path, size_t count) {
  std::string end = path.substr(path.size() - std::min(path.size(), count));
  for (char& c : end) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return end;
}

bool has_surface(const Model& model) {
  for (const auto table : {jalon_model_faces, jalon_model_triangles}) {
    Fields fields;
    must(table(model.get(), Out(fields)));
    if (Table(std::move(fields)).rows() > 0) return true;
  }
  return false;
}

struct Clearance {
  Common common;
  std::vector<std::string> inputs;
  std::string gauge, trajectory, output;
  Input cloud;  ///< how a scan among the inputs is read
  int64_t part = -1, other_part = -1;
  Settings settings;
  ViewerOption viewer;

  using Page = std::function<void(const std::string& path)>;  ///< writes the report

  /// What the files hold: at most a cloud, and models in their order.
  struct Scene {
    Cloud cloud;
    std::vector<Model> models;
    Lengths lengths;
    std::vector<jalon_box> boxes;

    void note(const Lengths& more, const jalon_box& box) {
      lengths = boxes.empty() ? more : lengths.with(more);
      boxes.push_back(box);
    }
  };

  // A file of points or of surfaces; PLY and text may be either, and without a surface they are a cloud.
  void read(Console& console, const std::string& path, Scene& scene) const {
    const std::string end = lower_end(path, 4);
    const bool points_only = end == ".las" || end == ".laz" || end == ".e57" || end == ".xyz" ||
                             end == ".txt" || end == ".csv";
    if (!points_only) {
      Model model;
      must_read(jalon_model_read(path.c_str(), nullptr, console.task(), Out(model)));
      if (has_surface(model) || end != ".ply") {
        scene.note(Lengths::of(path, model), box_of(model));
        scene.models.push_back(std::move(model));
        return;
      }
    }
    if (scene.cloud)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, path + " is a second cloud; one at most"};
    Input input = cloud;
    input.path = path;
    scene.cloud = input.read(console);
    scene.note(Lengths::of(input, scene.cloud), box_of(scene.cloud));
  }

  void run() const {
    const Params options = make_params("clearance");
    settings.apply(options.get());
    if (gauge.empty() != trajectory.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--gauge and --trajectory go together"};
    if (!gauge.empty() && (part >= 0 || other_part >= 0))
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--part and --other-part are without a gauge"};
    if (!output.empty()) check_output_folder(output);
    Console console(common);
    console.step("reading");
    Scene scene;
    for (const std::string& path : inputs) read(console, path, scene);
    if (!scene.cloud && cloud.is_told())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "unit, columns, box and the like are of a scan, and none is among the inputs"};
    Json result{{"inputs", inputs}};
    const char* parameters = nullptr;
    must(jalon_params_to_json(options.get(), &parameters));
    result["parameters"] = Json::parse(parameters);
    if (gauge.empty()) measure(console, scene, options, result);
    else sweep(console, scene, options, result);
    console.result(result);
  }

  void measure(Console& console, const Scene& scene, const Params& options, Json& result) const {
    if (inputs.size() == 2 && scene.boxes.size() == 2)
      warn_of_sizes(console, inputs[0], scene.boxes[0], inputs[1], scene.boxes[1]);
    const auto row = [](int64_t number) {
      return number < 0 ? JALON_WHOLE_MODEL : static_cast<uint64_t>(number);
    };
    Fields summary_fields, near_fields;
    console.step("measuring");
    if (scene.models.size() == 1 && scene.cloud)
      must(jalon_model_clearance(scene.models[0].get(), row(part), scene.cloud.get(), options.get(),
                                 console.task(), Out(summary_fields), Out(near_fields)));
    else if (scene.models.size() == 2 && !scene.cloud)
      must(jalon_model_clearance_to_model(scene.models[0].get(), row(part), scene.models[1].get(),
                                          row(other_part), options.get(), console.task(),
                                          Out(summary_fields), Out(near_fields)));
    else
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "without a gauge give a model and a cloud, or two models"};
    const Table summary(std::move(summary_fields)), near_rows(std::move(near_fields));
    result.update(summary.object(0));
    const double clearance = summary.number("clearance", 0);
    console.say(summary.count("interferes", 0) != 0
                    ? "they interfere, depth " + fixed(-clearance, 4) + " " + scene.lengths.length()
                    : "least distance " + fixed(clearance, 4) + " " + scene.lengths.length());
    console.say(grouped(near_rows.rows()) + (scene.cloud ? " points" : " triangles") +
                " within the margin");
    if (!scene.lengths.is_known()) console.say(scene.lengths.note());
    write(console, result, {{"near.csv", near_rows.csv()}});
  }

  void sweep(Console& console, const Scene& scene, const Params& options, Json& result) const {
    if (scene.models.size() > 1)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "a gauge goes through one cloud, one model, or one of each"};
    const std::vector<jalon_transform> poses = read_trajectory(trajectory);
    jalon_model* model = scene.models.empty() ? nullptr : scene.models[0].get();
    Fields place_fields, interval_fields;
    Gauge pieces;  // or a model:
    Model shape;
    if (lower_end(gauge, 5) == ".json" && lower_end(gauge, 10) != ".city.json") {
      pieces = read_gauge(gauge);
      console.step("sweeping");
      must(jalon_gauge_sweep(pieces.pieces.data(), pieces.pieces.size(), pieces.hull_points.data(),
                             pieces.hull_points.size() / 3, poses.data(), poses.size(),
                             scene.cloud.get(), model, options.get(), console.task(),
                             Out(place_fields), Out(interval_fields)));
    } else {
      must_read(jalon_model_read(gauge.c_str(), nullptr, console.task(), Out(shape)));
      console.step("sweeping");
      must(jalon_gauge_sweep_model(shape.get(), poses.data(), poses.size(), scene.cloud.get(),
                                   model, options.get(), console.task(), Out(place_fields),
                                   Out(interval_fields)));
    }
    const Table places(std::move(place_fields)), intervals(std::move(interval_fields));
    const Json notes{{"title", "Clearance report"},
                     {"input",
                      {{"obstacles", inputs[0] + (inputs.size() > 1 ? ", " + inputs[1] : "")},
                       {"gauge", gauge},
                       {"trajectory", trajectory}}}};
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    const Page page = [&](const std::string& path) {
      const Params wanted = viewer.params("clearance_report");
      double margin = 0;
      must(jalon_params_get_double(options.get(), "margin_m", &margin));
      must(jalon_params_set_double(wanted.get(), "margin_m", margin));
      must(jalon_report_write_clearance(places.fields(), intervals.fields(), pieces.pieces.data(),
                                        pieces.pieces.size(), pieces.hull_points.data(),
                                        pieces.hull_points.size() / 3, shape.get(), poses.data(),
                                        poses.size(), scene.cloud.get(), model, text.c_str(),
                                        path.c_str(), wanted.get(), console.task()));
    };
    report(console, options, poses.size(), places, intervals, result, scene.lengths, page);
  }

  void report(const Console& console, const Params& options, size_t poses, const Table& places,
              const Table& intervals, Json& result, const Lengths& lengths,
              const Page& page) const {
    std::vector<double> clearances;
    uint64_t worst = 0, below = 0, touching = 0;
    double margin = 0, reach = 0;
    must(jalon_params_get_double(options.get(), "margin_m", &margin));
    must(jalon_params_get_double(options.get(), "reach_m", &reach));
    for (uint64_t i = 0; i < intervals.rows(); ++i) {
      clearances.push_back(intervals.number("clearance", i));
      if (!(clearances[i] >= clearances[worst])) worst = std::isnan(clearances[i]) ? worst : i;
      if (std::isnan(clearances[worst])) worst = i;
      below += clearances[i] <= margin;
      touching += clearances[i] <= 0;
    }
    result["poses"] = poses;
    result["least"] = intervals.object(worst);
    result["intervals_within_margin"] = below;
    result["intervals_touching"] = touching;
    result["places"] = places.rows();
    if (std::isnan(clearances[worst]))
      console.say("nothing within " + fixed(std::max(margin, reach), 3) + " " + lengths.length() +
                  " of the gauge");
    else
      console.say("least clearance " + fixed(clearances[worst], 4) + " " + lengths.length() +
                  " at pose " + fixed(intervals.number("parameter", worst), 3));
    console.say(grouped(below) + " of " + grouped(intervals.rows()) +
                " pose intervals within the margin, " + grouped(touching) + " touch; " +
                grouped(places.rows()) + (places.rows() == 1 ? " place" : " places"));
    if (!lengths.is_known()) console.say(lengths.note());
    write(console, result,
          {{"places.csv", places.csv()},
           {"intervals.csv", intervals.csv()},
           {"clearance.svg", clearance_drawing(clearances, margin, reach, lengths.length())}},
          page);
  }

  void write(const Console& console, Json& result,
             std::vector<std::pair<std::string, std::string>> files, const Page& page = {}) const {
    if (output.empty()) return;
    files.emplace_back("clearance.json",
                       result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    OutputFolder folder(output);
    std::string names;
    for (const auto& [name, text] : files) {
      write_text_file(folder.path(name), text);
      names += (names.empty() ? "" : ", ") + name;
    }
    if (page) {
      page(folder.path("report.html"));
      names += ", report.html";
    }
    folder.commit();
    console.say("wrote " + output + ": " + names);
  }
};

}  // namespace

void add_clearance(Command& app) {
  Command command =
      app.subcommand("clearance", "Clearance of a model from a cloud or model; sweeps a gauge");
  auto state = std::make_shared<Clearance>();
  command
      .option("inputs", state->inputs,
              "A model and a cloud or another model; with a gauge a cloud, a model or both")
      .required()
      .expected(1, 2)
      .type_name("FILE");
  command.option("--gauge", state->gauge, "Gauge: a JSON file, or a model whose parts are convex")
      .type_name("FILE");
  command.option("--trajectory", state->trajectory, "Poses of the gauge, a line each")
      .type_name("FILE");
  command.option("--part", state->part, "Row of the model's part; else all of it").non_negative();
  command.option("--other-part", state->other_part, "The same of the other model").non_negative();
  state->cloud.add_points_to(command);
  command
      .option("-o,--output", state->output,
              "Also write tables, drawing, JSON and, with a gauge, the report here")
      .type_name("DIR");
  state->settings.add_to(command);
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("clearance").get()) + R"(
Clearances are signed: negative is the depth inside. A gauge is a file such as
  {"pieces": [{"type": "box", "size": [4, 2.6, 3.2], "at": [0, 0, 1.6]},
              {"type": "cylinder", "radius": 0.4, "length": 2, "at": [0, 0, 3], "axis": [1, 0, 0]},
              {"type": "sphere", "radius": 0.5, "at": [2, 0, 1]}, {"type": "hull", "points": [[0, 0, 0], ...]}]}
A trajectory has a pose a line: x y z (the gauge's x looks along the path, z up), [time] x y z qx qy qz qw, or the 12
numbers of the rows [R | t]. Between two poses nothing is missed, however far they are apart.
Exit codes: 0 measured, whatever the clearance; others as in jalon --help.

Examples:
  jalon clearance pipe.obj scan.las --set margin_m=0.05 -o result
  jalon clearance tunnel.las --gauge gauge.json --trajectory track.txt -o result)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
