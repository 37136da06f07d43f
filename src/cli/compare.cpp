// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/output_folder.h"
#include "cli/registration_file.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMethods[] = {"distance", "m3c2", "preview"};
constexpr const char* kClasses[] = {"", "appearance", "disappearance", "displacement", "displacement with overlap",
                                    "deformation", "deformation with overlap"};

struct Compare {
  Common common;
  Settings settings, change_settings;
  Input reference, compared;
  std::string method = "distance", registration, output;
  double threshold_m = 0;  ///< 0 = the operation's default
  bool is_one_way = false;

  // Files that hold a model and no points.
  bool is_model() const {
    const std::string& path = reference.path;
    for (const std::string end : {".obj", ".stl", ".json", ".OBJ", ".STL", ".JSON"})
      if (path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0) return true;
    return false;
  }

  // What one direction gave.
  struct Direction {
    Comparison comparison;
    Fields points;  ///< "changed", "region" and, both ways, "change"
    std::unique_ptr<Table> summary;
  };

  Comparer comparer(Params& params) const {
    Comparer made;
    must(jalon_comparer_create(method.c_str(), Out(made)));
    must(jalon_comparer_params(made.get(), Out(params)));
    if (!registration.empty()) use_registration_file(registration, params.get());
    settings.apply(params.get());
    return made;
  }

  Params change_options(const char* operation) const {
    Params options = make_params(operation);
    if (threshold_m > 0) must(jalon_params_set_double(options.get(), "threshold_m", threshold_m));
    change_settings.apply(options.get());
    return options;
  }

  Direction run_model(const Console& console, const Comparer& worker, const Cloud& to) const {
    Model model;
    must(jalon_model_read(reference.path.c_str(), nullptr, console.task(), Out(model)));
    Comparison made;
    must(jalon_comparer_run_model(worker.get(), model.get(), to.get(), console.task(), Out(made)));
    return direction_of(std::move(made));
  }

  static Direction run_one(const Console& console, const Comparer& worker, const Cloud& from, const Cloud& to) {
    Comparison made;
    must(jalon_comparer_run(worker.get(), from.get(), to.get(), console.task(), Out(made)));
    return direction_of(std::move(made));
  }

  static Direction direction_of(Comparison made) {
    Direction out;
    out.comparison = std::move(made);
    Fields summary;
    must(jalon_comparison_summary(out.comparison.get(), Out(summary)));
    out.summary = std::make_unique<Table>(std::move(summary));
    return out;
  }

  static void write_cloud(const Console& console, OutputFolder& folder, const Direction& direction, const char* name) {
    Cloud cloud;
    must(jalon_comparison_cloud(direction.comparison.get(), Out(cloud)));
    uint64_t columns = 0;
    must(jalon_fields_count(direction.points.get(), &columns));
    for (uint64_t i = 0; i < columns; ++i) {
      jalon_field_info info{};
      info.struct_size = sizeof info;
      must(jalon_fields_info(direction.points.get(), i, &info));
      jalon_array_view view;
      must(jalon_fields_view(direction.points.get(), info.name, &view));
      must(jalon_cloud_set_field(cloud.get(), info.name, view.data, view.type, view.components, view.count,
                                 view.stride_bytes, info.unit, info.meaning));
    }
    for (const char* extension : {".las", ".ply"})
      must(jalon_cloud_write(cloud.get(), folder.path(std::string(name) + extension).c_str(), nullptr, console.task()));
  }

  void write_report(const Console& console, OutputFolder& folder, const Direction& forward, const Direction& reverse,
                    const Fields& changes, const Params& change_options, const Json& times) const {
    double threshold = 0;
    must(jalon_params_get_double(change_options.get(), "threshold_m", &threshold));
    const Params options = make_params("comparison_report");
    must(jalon_params_set_double(options.get(), "threshold_m", threshold));
    const Json notes{{"title", "Comparison"},
                     {"input", {{"reference", reference.path}, {"compared", compared.path}, {"method", method}}},
                     {"times", times}};
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    must(jalon_report_write_comparison(forward.comparison.get(), reverse.comparison.get(), changes.get(), text.c_str(),
                                       folder.path("report.html").c_str(), options.get(), console.task()));
    must(jalon_report_write_histogram(forward.comparison.get(), folder.path("histogram.svg").c_str(), options.get(),
                                      console.task()));
    must(jalon_report_write_deviations(forward.comparison.get(), folder.path("distances.svg").c_str(), nullptr,
                                       console.task()));
  }

  static void say_summary(const Console& console, const char* name, const Table& summary) {
    char line[200];
    std::snprintf(line, sizeof line, "%s: %s points, %s compared, mean %s mm, rms %s mm, sigma %s mm, maximum %s m",
                  name, grouped(summary.count("points", 0)).c_str(), grouped(summary.count("compared", 0)).c_str(),
                  fixed(1000 * summary.number("mean", 0), 2).c_str(),
                  fixed(1000 * summary.number("rms", 0), 2).c_str(),
                  fixed(1000 * summary.number("sigma", 0), 2).c_str(), fixed(summary.number("maximum", 0), 3).c_str());
    console.say(line);
  }

  static void list_changes(const Console& console, const Table& changes) {
    console.say("change  class                       confidence   area before, after m2   displacement m");
    for (uint64_t i = 0; i < changes.rows(); ++i) {
      const double dx = changes.number("displacement", i, 0), dy = changes.number("displacement", i, 1),
                   dz = changes.number("displacement", i, 2);
      const bool is_moved = dx == dx;
      char line[200];
      std::snprintf(line, sizeof line, "%6u  %-26s %11s %12s %10s   %s", static_cast<unsigned>(i + 1),
                    kClasses[changes.count("class", i)], fixed(changes.number("confidence", i), 2).c_str(),
                    fixed(changes.number("area_before", i), 3).c_str(),
                    fixed(changes.number("area_after", i), 3).c_str(),
                    is_moved ? (fixed(dx, 3) + " " + fixed(dy, 3) + " " + fixed(dz, 3)).c_str() : "");
      console.say(line);
    }
  }

  static void list_regions(const Console& console, const Table& regions) {
    console.say("region     points    area m2    mean mm   extreme mm   centroid m");
    for (uint64_t i = 0; i < regions.rows(); ++i) {
      char line[200];
      std::snprintf(line, sizeof line, "%6u %10s %10s %10s %12s   %s %s %s", static_cast<unsigned>(i + 1),
                    grouped(regions.count("points", i)).c_str(), fixed(regions.number("area", i), 3).c_str(),
                    fixed(1000 * regions.number("mean", i), 1).c_str(),
                    fixed(1000 * regions.number("extreme", i), 1).c_str(),
                    fixed(regions.number("centroid", i, 0), 2).c_str(),
                    fixed(regions.number("centroid", i, 1), 2).c_str(),
                    fixed(regions.number("centroid", i, 2), 2).c_str());
      console.say(line);
    }
  }

  void run() const {
    Console console(common);
    Params params;
    const Comparer worker = comparer(params);  // wrong parameters are told before a long read
    const bool both = !is_one_way && method == "distance" && !is_model();
    const Params options = change_options(both ? "diagnosis" : "regions");
    console.step("reading");
    const Cloud after = compared.read(console);
    const Cloud before = is_model() ? Cloud() : reference.read(console);
    Json times{{"read", console.seconds()}};
    console.step("comparing");
    Direction forward = is_model() ? run_model(console, worker, after) : run_one(console, worker, before, after);
    Direction reverse;
    if (both) reverse = run_one(console, worker, after, before);
    times["compare"] = console.seconds();
    console.step("changes");
    Fields found;
    if (both)
      must(jalon_comparison_diagnose(forward.comparison.get(), reverse.comparison.get(), options.get(), console.task(),
                                     Out(forward.points), Out(reverse.points), Out(found)));
    else
      must(jalon_comparison_regions(forward.comparison.get(), options.get(), console.task(), Out(forward.points),
                                    Out(found)));
    times["changes"] = console.seconds();
    const Fields table(jalon_fields_retain(found.get()));
    const Table changes(std::move(found));
    console.step("writing");
    OutputFolder folder(output);
    write_cloud(console, folder, forward, "compared");
    if (both) write_cloud(console, folder, reverse, "reference");
    const char* list = both ? "changes" : "regions";
    write_text_file(folder.path(std::string(list) + ".csv"), changes.csv());
    const char *parameters = nullptr, *change_parameters = nullptr;
    must(jalon_params_to_json(params.get(), &parameters));
    must(jalon_params_to_json(options.get(), &change_parameters));
    Json result{{"reference", reference.path}, {"compared", compared.path}, {"output", output}, {"method", method},
                {"parameters", Json::parse(parameters)}, {"change_parameters", Json::parse(change_parameters)},
                {"times", times}, {"summary", forward.summary->object(0)}};
    if (both) result["reverse_summary"] = reverse.summary->object(0);
    result[list] = changes.list();
    write_text_file(folder.path("comparison.json"), result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    write_report(console, folder, forward, reverse, table, options, times);
    folder.commit();
    say_summary(console, both ? "compared with the reference" : "compared", *forward.summary);
    if (both) say_summary(console, "reference with the compared", *reverse.summary);
    both ? list_changes(console, changes) : list_regions(console, changes);
    console.say("wrote " + output + ": report.html, comparison.json, histogram.svg, distances.svg, " +
                list + ".csv, compared.las, compared.ply" +
                (both ? ", reference.las, reference.ply" : ""));
    console.result(result);
  }
};

std::string tables() {
  std::string text;
  for (const char* method : kMethods) {
    Comparer comparer;
    must(jalon_comparer_create(method, Out(comparer)));
    Params params;
    must(jalon_comparer_params(comparer.get(), Out(params)));
    text += std::string("Parameters of --set with --method ") + method + ":\n" + describe(params.get()) + "\n";
  }
  return text + "Parameters of --change-set:\n" + describe(make_params("diagnosis").get()) + "\n";
}

}  // namespace

void add_compare(CLI::App& app) {
  auto* command = app.add_subcommand("compare", "Two scans, or a scan and a model: distances, what changed, and how");
  auto state = std::make_shared<Compare>();
  command->add_option("reference", state->reference.path,
                      "The scan (before) or the model (.obj, .stl, .city.json) that distances are taken from")
      ->required()
      ->type_name("REFERENCE");
  command->add_option("compared", state->compared.path, "The scan whose points get them (after)")
      ->required()
      ->type_name("COMPARED");
  command->add_option("-o,--output", state->output, "Folder for the results")->required()->type_name("DIR");
  command->add_option("--method", state->method,
                      "How distances are measured; the parameters below tell which there are")
      ->capture_default_str()
      ->type_name("NAME");
  command->add_option("--registration", state->registration,
                      "registration.json of \"jalon register\": its covariance joins m3c2's level of detection")
      ->type_name("FILE");
  command->add_option("--threshold", state->threshold_m, "Distance (m) above which a point has changed")
      ->check(CLI::PositiveNumber);
  command->add_flag("--one-way", state->is_one_way,
                    "Only the compared scan with the reference: regions instead of classes of changes");
  for (const bool is_reference : {true, false}) {
    Input& input = is_reference ? state->reference : state->compared;
    const std::string prefix = is_reference ? "--reference-" : "--compared-";
    command->add_option(prefix + "columns", input.columns,
                        "Columns of a text file, e.g. \"x y z intensity\"; - skips one")
        ->type_name("NAMES");
    command->add_option(prefix + "station", input.station, "Where its scanner stood, for all points")
        ->type_name("X,Y,Z");
  }
  command->add_flag_callback(
      "--drop-invalid", [state] { state->reference.drop_invalid = state->compared.drop_invalid = true; },
      "Drop points whose coordinates are not finite");
  state->settings.add_to(*command);
  state->change_settings.add_to(*command, "change-");
  add_common(*command, state->common);
  command->footer([] {
    return tables() +
           "Examples:\n  jalon compare march.las april.las -o changes\n"
           "  jalon compare march.las april.las -o changes --one-way --threshold 0.02 --set max_distance_m=1\n"
           "  jalon compare model.city.json scan.las -o as_built --set tolerance_m=0.01\n"
           "  jalon compare march.las april.las -o creep --method m3c2 --set core_spacing_m=0.5";
  });
  command->callback([state] { state->run(); });
}

}  // namespace jalon::cli
