// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/model_files.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ModelJob {
  ViewerOption viewer;
  Common common;
  Input input;
  Settings settings, segment_settings;
  ModelFiles files;
  std::string method = "facade", segmenter = "ransac", labels, output;
  std::vector<double> noise;
  double tolerance_m = 0;  ///< 0 = the segmenter's default

  // Wrong parameters are told before a long read.
  struct Workers {
    Segmenter segmenter;
    Modeller modeller;
    Params segmenter_params, modeller_params;
  };

  Workers workers() const {
    Workers out;
    out.modeller = make_modeller(method, out.modeller_params);
    settings.apply(out.modeller_params.get());
    if (!labels.empty() && (segment_settings.is_given() || tolerance_m > 0))
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "--labels takes the segments as they are: no --tolerance, no --segment-set"};
    if (labels.empty() && !noise.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--noise-label needs --labels"};
    out.segmenter = make_segmenter(segmenter, out.segmenter_params);
    if (tolerance_m > 0)
      must(
          jalon_params_set_double(out.segmenter_params.get(), "distance_tolerance_m", tolerance_m));
    segment_settings.apply(out.segmenter_params.get());
    return out;
  }

  Segmentation segments(const Console& console, const Cloud& cloud, const Workers& workers) const {
    Segmentation made;
    if (labels.empty()) {
      must(jalon_segmenter_run(workers.segmenter.get(), cloud.get(), console.task(), Out(made)));
      return made;
    }
    const Params options = make_params("labels");
    if (!noise.empty())
      must(jalon_params_set_doubles(options.get(), "noise_labels", noise.data(), noise.size()));
    must(jalon_segmentation_from_labels(cloud.get(), labels.c_str(), options.get(), console.task(),
                                        Out(made)));
    return made;
  }

  std::vector<std::string> write(const Console& console, const Segmentation& segmentation,
                                 const Model& model, Json notes) const {
    OutputFolder folder(output);
    auto names = files.write(console, segmentation.get(), model.get(), input.path, folder);
    notes["times"]["write"] = console.seconds();
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    names.insert(names.begin(), {"report.html", "report.json"});
    must(jalon_report_write_html(segmentation.get(), model.get(), text.c_str(),
                                 folder.path(names[0]).c_str(), viewer.params("report").get(),
                                 console.task()));
    must(jalon_report_write_json(segmentation.get(), model.get(), text.c_str(),
                                 folder.path(names[1]).c_str(), nullptr, console.task()));
    folder.commit();
    return names;
  }

  void run() const {
    Console console(common);
    check_output_folder(output);
    const Workers tools = workers();
    files.check();
    const std::string source = labels.empty() ? segmenter : "labels of field " + labels;
    Json notes{{"title", "Model"},
               {"input", {{"file", input.path}, {"segments", source}, {"method", method}}},
               {"times", Json::object()}};
    console.step("reading");
    const Cloud cloud = input.read(console);
    notes["times"]["read"] = console.seconds();
    files.note_scanner(cloud.get(), notes);
    const Lengths lengths = Lengths::of(input, cloud);
    notes["input"]["unit"] = lengths.in_report();
    console.step("segments");
    const Segmentation segmentation = segments(console, cloud, tools);
    notes["times"]["segment"] = console.seconds();
    console.step("model");
    Model model;
    must(jalon_modeller_run(tools.modeller.get(), cloud.get(), segmentation.get(), console.task(),
                            Out(model)));
    const Json summary = summary_of(model.get());
    if (summary["faces"] == 0)
      found_nothing(input, cloud, "no face",
                    labels.empty() ? "--tolerance, --segment-set, --model-set" : "--model-set");
    notes["times"]["model"] = console.seconds();
    console.step("writing");
    const auto names = write(console, segmentation, model, notes);
    const char* parameters = nullptr;
    must(jalon_params_to_json(tools.modeller_params.get(), &parameters));
    console.say(summary_line(summary));
    console.say("wrote " + output + ": " + joined(names));
    if (labels.empty())
      if (const std::string note = noise_note(tools.segmenter.get(), segmentation.get(), lengths);
          !note.empty())
        console.say(note);
    if (const std::string note = front_note(segmentation.get()); !note.empty()) console.say(note);
    console.result({{"input", input.path},
                    {"points", count_of(cloud)},
                    {"output", output},
                    {"segments", source},
                    {"method", method},
                    {"parameters", Json::parse(parameters)},
                    {"times", notes["times"]},
                    {"model", summary},
                    {"files", names}});
  }
};

}  // namespace

void add_model(Command& app) {
  Command command = app.subcommand(
      "model", "From segments to a vector model: files for CAD, a drawing and a report");
  auto state = std::make_shared<ModelJob>();
  state->input.add_to(command);
  add_output_folder(command, state->output);
  command
      .option(
          "--labels", state->labels,
          "Field with the segment of each point (what \"jalon segment\" wrote, hand labels ...); "
          "without it the points are segmented first")
      .type_name("FIELD");
  command
      .option("--noise-label", state->noise, "A label that is no segment; default 0 (repeatable)")
      .type_name("LABEL")
      .one_each_time();
  command
      .option("--method", state->method,
              "How the model is made; the parameters below tell which methods there are")
      .shows_default()
      .type_name("NAME");
  command.option("--segmenter", state->segmenter, "How segments are found without --labels")
      .shows_default()
      .type_name("NAME");
  command
      .option("--tolerance", state->tolerance_m,
              "Half-thickness of a plane (m); default: the segmenter's")
      .positive();
  state->settings.add_to(command, "model-");
  state->settings.add_short_to(command);
  state->segment_settings.add_to(command, "segment-");
  state->files.add_to(command);
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return modeller_tables("--model-set (or --set)") + segmenter_tables("--segment-set") +
           "Parameters of --drawing-set:\n" + describe(make_params("elevation").get()) +
           "\nParameters of --orthoimage-set:\n" + describe(make_params("orthoimage").get()) +
           "\nParameters of --scanner-set (precision of the scanner):\n" +
           describe(make_params("precision").get()) +
           "\nExamples:\n  jalon model scan.las -o result\n"
           "  jalon model segments.las -o result --labels label\n"
           "  jalon model scan.las -o result --segmenter region_growing --tolerance 0.01 "
           "--drawing-set scale=50\n"
           "  jalon model scan.las -o result --station 12.5,-8,1.7 --scanner-set "
           "sigma_range_m=0.002";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
