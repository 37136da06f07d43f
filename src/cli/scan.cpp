// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/inputs/drive_scan.h"
#include "cli/methods.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/text_file.h"

namespace jalon::cli {

namespace {

// Scenes are in metres, which the file is to tell.
constexpr const char* kSceneCrs = "LOCAL_CS[\"scene, metres\",UNIT[\"metre\",1]]";

constexpr const char* kOwnTruth =
    "grammar";                               // brings its scanner, and tells its walls and openings
constexpr const char* kCodedTruth = "yard";  // brings the code lists of a survey

using Json = nlohmann::ordered_json;

// Every point has the class of its face: the field "classification".
void classify(jalon_cloud* cloud, const Json& truth) {
  const auto classes = truth["face_classes"].get<std::vector<uint8_t>>();
  Fields fields;
  must(jalon_cloud_fields(cloud, Out(fields)));
  uint64_t count = 0;
  const auto* face = values<uint32_t>(fields, "face", &count);
  std::vector<uint8_t> of_point(count, 0);
  for (uint64_t i = 0; i < count; ++i)
    if (face[i] >= 1 && face[i] <= classes.size()) of_point[i] = classes[face[i] - 1];
  must(jalon_cloud_set_field(cloud, "classification", of_point.data(), JALON_UINT8, 1, count, 0, "",
                             "class of the point's true object"));
}

std::string lines_of(const Json& list) {
  std::string text;
  for (const Json& line : list) text += line.get<std::string>() + "\n";
  return text;
}

struct Scan {
  Common common;
  Settings settings, scene_settings;
  std::string scene = "facade", method = "static";
  std::string output, model_output, trajectory_output;
  int64_t drift_seed = 1, scenario = -1;
  std::vector<std::string> stations;

  void add_stations(jalon_scanner* scanner) const {
    for (const std::string& text : stations) {
      const jalon_transform pose = pose_at(text);
      must(jalon_scanner_add_station(scanner, nullptr, &pose));
    }
  }

  Params scene_options() const {
    Params options = make_params("scene");
    must(jalon_params_set_string(options.get(), "name", scene.c_str()));
    if (scene == kOwnTruth ||
        scene == kCodedTruth) {  // one seed for all, unless the scene's is told
      Scanner scanner;
      Params params;
      int64_t seed = 0;
      must_know(jalon_scanner_create(method.c_str(), Out(scanner)));
      must(jalon_scanner_params(scanner.get(), Out(params)));
      settings.apply(params.get());
      must(jalon_params_get_int64(params.get(), "seed", &seed));
      must(jalon_params_set_int64(options.get(), "seed", seed));
    }
    scene_settings.apply(options.get());
    return options;
  }

  /// The scene's own values stand before those told, its own stations where none are told.
  Scanner make_scanner(const Params& options) const {
    Scanner own, scanner;
    Params own_params, params;
    must(jalon_scene_scanner(options.get(), Out(own)));
    if (method == "static" && stations.empty()) {
      scanner = std::move(own);
      must(jalon_scanner_params(scanner.get(), Out(params)));
    } else {
      must_know(jalon_scanner_create(method.c_str(), Out(scanner)));
      must(jalon_scanner_params(scanner.get(), Out(params)));
      if (method == "static") {
        const char* values = nullptr;
        must(jalon_scanner_params(own.get(), Out(own_params)));
        must(jalon_params_to_json(own_params.get(), &values));
        must(jalon_params_from_json(params.get(), values));
      }
    }
    settings.apply(params.get());
    add_stations(scanner.get());
    return scanner;
  }

  std::string beside(const char* extension) const {
    return std::filesystem::path(output).replace_extension(extension).string();
  }

  /// Beside the cloud: NAME.truth.json. Of random points on all faces nothing is said to be seen or hidden.
  std::string truth_output() const {
    if (scene == kCodedTruth) return beside(".truth.json");
    return scene == kOwnTruth && method == "static" ? beside(".truth.json") : "";
  }

  /// The truth of the coded scene, its lists NAME.survey.txt and NAME.targets.txt, and classes for the points.
  void write_codes(const Console& console, const Params& options, const Cloud& cloud,
                   const std::string& truth_path) const {
    must(jalon_scene_write_truth(truth_path.c_str(), nullptr, options.get(), console.task()));
    const Json truth = Json::parse(read_text_file(truth_path));
    write_text_file(beside(".survey.txt"), lines_of(truth["survey"]));
    write_text_file(beside(".targets.txt"), lines_of(truth["targets"]));
    classify(cloud.get(), truth);
    console.say("codes -> " + beside(".survey.txt") + ", " + beside(".targets.txt"));
  }

  // A drive has a scene of its own: the street that it goes along.
  void drive() const {
    if (!stations.empty() || scene != "facade")
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "method mobile drives through a street of its own: no --scene, no --station"};
    if (trajectory_output.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "method mobile needs --trajectory FILE"};
    scan_by_drive(
        {settings, scene_settings, output, model_output, trajectory_output, drift_seed, scenario},
        common);
  }

  void run() const {
    check_output_file(output, "cloud");
    if (method == "mobile") return drive();
    if (!trajectory_output.empty() || scenario >= 0)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "--trajectory and --scenario are for --method mobile"};
    const std::string truth_path = truth_output();
    if (!truth_path.empty()) check_output_file(truth_path);
    if (!model_output.empty()) check_output_file(model_output, "model");
    Console console(common);
    console.step("scene");
    const Params options = scene_options();
    Model model;
    must(jalon_scene_create(options.get(), console.task(), Out(model)));
    console.step("scanning");
    const Scanner scanner = make_scanner(options);
    Cloud cloud;
    must(jalon_scanner_run(scanner.get(), model.get(), console.task(), Out(cloud)));
    if (count_of(cloud) == 0)
      throw Failure{JALON_ERROR_DEGENERATE,
                    "no pulse met scene \"" + scene + "\": do the stations see it?"};
    must(jalon_cloud_set_crs(cloud.get(), kSceneCrs));
    Fields truth;
    must(jalon_scanner_truth(scanner.get(), model.get(), cloud.get(), nullptr, Out(truth)));
    uint64_t true_planes = 0;
    values<uint32_t>(truth, "segment", &true_planes);
    const double seconds = console.seconds();
    console.step("writing");
    if (scene == kCodedTruth) write_codes(console, options, cloud, truth_path);
    must(jalon_cloud_write(cloud.get(), output.c_str(), nullptr, console.task()));
    if (!model_output.empty())
      must(jalon_model_write(model.get(), model_output.c_str(), nullptr, console.task()));
    if (!truth_path.empty() && scene == kOwnTruth)
      must(jalon_scene_write_truth(truth_path.c_str(), scanner.get(), options.get(),
                                   console.task()));
    console.say(grouped(count_of(cloud)) + " points of scene \"" + scene + "\" in " +
                fixed(seconds, 2) + " s -> " + output);
    if (!truth_path.empty()) console.say("truth -> " + truth_path);
    nlohmann::ordered_json result{{"scene", scene},
                                  {"output", output},
                                  {"points", count_of(cloud)},
                                  {"true_planes", true_planes},
                                  {"seconds", seconds}};
    if (!truth_path.empty()) result["truth"] = truth_path;
    console.result(result);
  }
};

std::string scanner_tables() {
  return method_tables<Scanner>("Parameters of --set with --method ", jalon_scanner_methods,
                                jalon_scanner_create, jalon_scanner_params);
}

}  // namespace

void add_scan(Command& app) {
  Command command = app.subcommand(
      "scan", "Scans a ready-made scene with a virtual scanner; the truth comes along as fields");
  auto state = std::make_shared<Scan>();
  command.option("--scene", state->scene, "Scene to scan; names below")
      .shows_default()
      .type_name("NAME");
  command
      .option("--method", state->method,
              "static: a tripod scanner; sample: random points on all faces; mobile: a vehicle "
              "that drives through a street")
      .shows_default()
      .type_name("NAME");
  command.option("-o,--output", state->output, "Scan to write").required().type_name("FILE");
  command.option("--model", state->model_output, "Also write the scene as a model (.obj)")
      .type_name("FILE");
  command
      .option("--trajectory", state->trajectory_output,
              "Method mobile: also write the trajectory (text), as a user has it")
      .type_name("FILE");
  command
      .option("--drift-seed", state->drift_seed,
              "Method mobile: of the errors of the trajectory, drawn from its sigmas; points stand "
              "where they put them; 0: without errors. Of a scenario: of all that is wrong")
      .shows_default()
      .type_name("N");
  command
      .option("--scenario", state->scenario,
              "Method mobile: the model too is wrong, in strips (1.5 m), and what is true is "
              "written as NAME.true beside it. "
              "What is 2 m off, all else 1 cm: 1 the trajectory, 2 blocks, 3 facades, 4 strips; 5: "
              "1 m, 1 m, 0.5 m and 0.3 m; "
              "0: by the sigmas of --scene-set")
      .type_name("N");
  command
      .option("--station", state->stations,
              "Scanner position; without one, two are placed in front (repeatable)")
      .type_name("X,Y,Z")
      .one_each_time();
  state->settings.add_to(command);
  state->scene_settings.add_to(command, "scene-");
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --scene-set (scene):\n" + describe(make_params("scene").get()) + "\n" +
           "Parameters of --scene-set with --method mobile (street_drive):\n" +
           describe(make_params("street_drive").get()) + "\n" +
           "Parameters of --scene-set with --scenario (drive_scenario):\n" +
           describe(make_params("drive_scenario").get()) + "\n" + scanner_tables() +
           "Examples: jalon scan --scene facade -o sample.las\n"
           "          jalon scan --scene insa --set instrument=gx --set max_points=200000 --set "
           "glass_return_min=0.05 "
           "--set glass_return_max=0.3 -o insa.las\n"
           "          jalon scan --scene grammar --set seed=7 -o street.las    (and "
           "street.truth.json)\n"
           "          jalon scan --scene yard --method sample --set spacing_m=0.02 --set "
           "densities=gutter=4 --set glass_return_min=0.05 --set glass_return_max=0.05 -o yard.las"
           "    (and yard.survey.txt, yard.targets.txt)\n"
           "          jalon scan --method mobile -o drive.ply --model street.obj --trajectory "
           "drive.txt --scene-set sigma_position_m=1\n"
           "          jalon scan --scene patches --method sample --set points=60000 -o patches.las";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
