// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/outputs/edge_curve.h"
#include "cli/outputs/method_comparison.h"
#include "cli/outputs/raster_file.h"
#include "cli/methods.h"
#include "cli/model_files.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/inputs/picks.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Segment {
  ViewerOption viewer;
  Common common;
  Input input;
  Settings settings;
  std::string method = "ransac", output, view = "front";
  double tolerance_m = 0;  ///< 0 = the method's default
  Picks picks;
  EdgeCurveFiles edge_curve;
  RasterFile raster;
  MethodComparison comparison;

  Segmenter segmenter(Params& params) const {
    Segmenter made;
    must_know(jalon_segmenter_create(method.c_str(), Out(made)));
    must(jalon_segmenter_params(made.get(), Out(params)));
    if (tolerance_m > 0)
      must(jalon_params_set_double(params.get(), "distance_tolerance_m", tolerance_m));
    settings.apply(params.get());
    return made;
  }

  void draw(const Console& console, const Segmentation& segmentation,
            const std::string& path) const {
    const Params options = make_params("picture");
    must(jalon_params_set_string(options.get(), "title",
                                 std::filesystem::path(input.path).filename().string().c_str()));
    must(jalon_params_set_string(options.get(), "view", view.c_str()));
    must(jalon_report_write_picture(segmentation.get(), path.c_str(), options.get(),
                                    console.task()));
  }

  /// The names of the files beyond those of every run.
  std::vector<std::string> write(const Console& console, const Segmentation& segmentation,
                                 const Params& params, const Table& table, Json notes,
                                 Json result) const {
    OutputFolder folder(output);
    Cloud labelled;
    must(jalon_segmentation_cloud(segmentation.get(), Out(labelled)));
    must(jalon_cloud_write(labelled.get(), folder.path("segments.las").c_str(), nullptr,
                           console.task()));
    must(jalon_cloud_write(labelled.get(), folder.path("segments.ply").c_str(), nullptr,
                           console.task()));
    write_text_file(folder.path("segments.csv"), table.csv());
    must(jalon_segmentation_write_primitives(segmentation.get(),
                                             folder.path("primitives.txt").c_str()));
    draw(console, segmentation, folder.path("segments.svg"));
    std::vector<std::string> more = edge_curve.write(
        console, segmentation, [&](const char* name) { return folder.path(name); });
    for (const std::string& name : raster.write(console, labelled, params, table,
                                                [&](const char* own) { return folder.path(own); }))
      more.push_back(name);
    notes["times"]["write"] = console.seconds();
    result["times"] = notes["times"];
    write_text_file(folder.path("segments.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    must(jalon_report_write_html(segmentation.get(), nullptr, text.c_str(),
                                 folder.path("report.html").c_str(), viewer.params("report").get(),
                                 console.task()));
    folder.commit();
    return more;
  }

  static std::string shape(const Table& table, uint64_t row) {
    const auto type = table.count("type", row);
    const std::string radius = fixed(table.number("radius", row), 4);
    if (type == JALON_PRIMITIVE_SPHERE) return "sphere " + radius;
    std::string direction = fixed(table.number("normal", row, 0), 4);
    for (const uint32_t k : {1u, 2u}) direction += " " + fixed(table.number("normal", row, k), 4);
    return type == JALON_PRIMITIVE_CYLINDER ? "cylinder " + radius + ", " + direction : direction;
  }

  static void list(const Console& console, const Table& table, const Lengths& lengths) {
    console.say("segment     points " + lengths.heading("area", "m2", 10) +
                lengths.heading("sigma", "mm", 11) + "   normal, or radius" +
                (lengths.is_known() ? " in m" : "") + " and axis");
    for (uint64_t i = 0; i < table.rows(); ++i) {
      char line[200];
      std::snprintf(line, sizeof line, "%7u %10s %10s %10s   %s",
                    static_cast<unsigned>(table.count("label", i)),
                    grouped(table.count("inliers", i)).c_str(),
                    fixed(table.number("area", i), 2).c_str(),
                    lengths.fine(table.number("sigma", i), 1).c_str(), shape(table, i).c_str());
      console.say(line);
    }
  }

  // Every method on the same scan, as a table and a page.
  void compare(Console& console) const {
    if (picks.are_given() || settings.is_given() || edge_curve.label > 0 || raster.wanted())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "--compare-methods takes every method with its defaults: no --pick, no "
                    "--segment-set, no --edge-curve, no --raster"};
    console.step("reading");
    const Cloud cloud = input.read(console);
    Segmentation reference;
    if (!comparison.labels.empty())
      must(jalon_segmentation_from_labels(cloud.get(), comparison.labels.c_str(), nullptr,
                                          console.task(), Out(reference)));
    OutputFolder folder(output);
    std::vector<MethodComparison::Row> rows;
    const char* const* names = nullptr;
    uint64_t count = 0;
    must(jalon_segmenter_methods(&names, &count));
    // "ransac", the first, widens its tolerance for a noisy scan; the others get the same.
    double tolerance_for_all_m = tolerance_m;
    std::string note;
    for (uint64_t i = 0; i < count; ++i) {
      console.step(names[i]);
      Segmentation segmentation;
      const auto row = comparison.run(console, names[i], cloud, reference.get(),
                                      tolerance_for_all_m, segmentation);
      if (!row) continue;
      if (note.empty() && tolerance_m == 0 && row->planes > 0) {
        Params defaults;
        const Segmenter plain = make_segmenter(names[i], defaults);
        note = noise_note(plain.get(), segmentation.get(), Lengths::of(input, cloud));
        if (!note.empty()) tolerance_for_all_m = used_tolerance_m(segmentation.get());
      }
      rows.push_back(*row);
      if (row->planes > 0) draw(console, segmentation, folder.path(std::string(names[i]) + ".svg"));
    }
    const Json result{{"input", input.path},
                      {"points", count_of(cloud)},
                      {"output", output},
                      {"methods", MethodComparison::json(rows)},
                      {"advice", MethodComparison::advice(rows)}};
    write_text_file(folder.path("methods.csv"), MethodComparison::csv(rows));
    write_text_file(folder.path("methods.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    write_text_file(
        folder.path("methods.html"),
        MethodComparison::page(std::filesystem::path(input.path).filename().string(), rows));
    folder.commit();
    for (const std::string& line : MethodComparison::lines(rows)) console.say(line);
    console.say(MethodComparison::advice(rows));
    if (!note.empty()) console.say(note);
    console.say("wrote " + output + ": methods.html, methods.csv, methods.json, pictures");
    console.result(result);
  }

  void run() const {
    Console console(common);
    Params params;
    check_output_folder(output);
    comparison.check();
    if (comparison.wanted) return compare(console);
    const Segmenter worker = segmenter(params);  // wrong parameters are told before a long read
    picks.check();
    edge_curve.check();
    raster.check(picks.are_given() ? "pick" : method);
    if (picks.are_given() && (settings.is_given() || tolerance_m > 0))
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "--pick grows segments by --pick-set: no --tolerance, no --segment-set"};
    Json notes{{"title", "Segments"},
               {"input", {{"file", input.path}, {"method", picks.are_given() ? "pick" : method}}},
               {"times", Json::object()}};
    console.step("reading");
    const Cloud cloud = input.read(console);
    notes["times"]["read"] = console.seconds();
    const Lengths lengths = Lengths::of(input, cloud);
    notes["input"]["unit"] = lengths.in_report();
    console.step("segments");
    Segmentation segmentation;
    if (picks.are_given()) segmentation = picks.grown(console, cloud);
    else must(jalon_segmenter_run(worker.get(), cloud.get(), console.task(), Out(segmentation)));
    notes["times"]["segment"] = console.seconds();
    Fields fields;
    must(jalon_segmentation_segments(segmentation.get(), Out(fields)));
    const Table table(std::move(fields));
    if (table.rows() == 0) found_nothing(input, cloud, "no segment", "--tolerance, --segment-set");
    const char* parameters = nullptr;
    if (picks.are_given()) {
      params = make_params("pick");
      picks.settings.apply(params.get());
    }
    must(jalon_params_to_json(params.get(), &parameters));
    Json result{{"input", input.path},
                {"points", count_of(cloud)},
                {"output", output},
                {"method", picks.are_given() ? "pick" : method},
                {"parameters", Json::parse(parameters)},
                {"times", notes["times"]},
                {"segments", table.list()}};
    console.step("writing");
    const auto more = write(console, segmentation, params, table, notes, result);
    list(console, table, lengths);
    std::string names =
        "report.html, segments.svg, segments.csv, segments.json, segments.las, segments.ply, "
        "primitives.txt";
    for (const std::string& name : more) names += ", " + name;
    console.say("wrote " + output + ": " + names);
    if (const std::string note = noise_note(worker.get(), segmentation.get(), lengths);
        !note.empty())
      console.say(note);
    if (!lengths.is_known()) console.say(lengths.note());
    console.result(result);
  }
};

std::string tables_of_segment() {
  return method_tables<Segmenter>("Parameters of --segment-set (or --set) with --method ",
                                  jalon_segmenter_methods, jalon_segmenter_create,
                                  jalon_segmenter_params);
}

}  // namespace

void add_segment(Command& app) {
  Command command = app.subcommand(
      "segment", "From a scan to labelled points, a table of the segments and a picture of them");
  auto state = std::make_shared<Segment>();
  state->input.add_to(command);
  add_output_folder(command, state->output);
  command
      .option("--method", state->method,
              "How segments are found; the parameters below tell which there are")
      .shows_default()
      .type_name("NAME");
  command
      .option("--tolerance", state->tolerance_m,
              "Half-thickness of a plane (m); default: the method's")
      .positive();
  command.option("--view", state->view, "What the picture shows")
      .among({"front", "plan"})
      .shows_default();
  state->settings.add_to(command, "segment-");
  state->settings.add_short_to(command);
  state->picks.add_to(command);
  state->edge_curve.add_to(command);
  state->raster.add_to(command);
  state->viewer.add_to(command);
  state->comparison.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return tables_of_segment() + "Parameters of --pick-set:\n" +
           describe(make_params("pick").get()) + "\n" +
           "Examples:\n  jalon segment scan.las -o result\n"
           "  jalon segment scan.txt -o result --method ransac --tolerance 0.02 --set "
           "min_area_m2=0.2\n"
           "  jalon segment scan.las -o result --pick \"2.5,0,1.2\" --pick \"sphere:4,-1,1\"\n"
           "  jalon segment scan.las -o result --edge-curve 1\n"
           "  jalon segment scan.las -o result --method raster_growing --raster\n"
           "  jalon segment plant.las -o result --set primitives=all --set max_radius_m=1\n"
           "  jalon segment scan.las -o result --compare-methods --reference-labels face\n"
           "  jalon evaluate-segmentation result/segments.las reference.las";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
