// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/model_files.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/outputs/beside.h"
#include "cli/outputs/facade_advice.h"
#include "cli/system/memory.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* orientation_name(uint8_t orientation) {
  static constexpr const char* kNames[] = {"none", "parallel", "vertical", "horizontal",
                                           "inclined"};
  return orientation < 5 ? kNames[orientation] : "?";
}

const char* front_name(uint8_t source) {
  static constexpr const char* kNames[] = {"none", "station", "evidence"};
  return source < 3 ? kNames[source] : "?";
}

struct Facade {
  ViewerOption viewer;
  Common common;
  Input input;
  Settings settings, model_settings;
  ModelFiles files;
  std::string output, model_method = "facade";
  double tolerance_m = 0;  ///< 0 = the segmenter's default

  // Wrong parameters are told before a long read.
  Segmenter segmenter(const char* primitives = "planes") const {
    Params params;
    Segmenter made = make_segmenter("ransac", params);
    must(jalon_params_set_string(params.get(), "primitives", primitives));
    if (tolerance_m > 0)
      must(jalon_params_set_double(params.get(), "distance_tolerance_m", tolerance_m));
    settings.apply(params.get());
    return made;
  }

  // The planes; where these may be strips of bent walls, and nobody said what to look for, those walls as cylinders
  // with a word on them.
  Segmentation surfaces(Console& console, const Cloud& cloud, const Segmenter& planes_of,
                        std::string& hint) const {
    Segmentation planes, all;
    must(jalon_segmenter_run(planes_of.get(), cloud.get(), console.task(), Out(planes)));
    if (settings.sets("primitives") || !may_be_bent(planes)) return planes;
    console.step("bent walls");
    must(jalon_segmenter_run(segmenter("planes+cylinders").get(), cloud.get(), console.task(),
                             Out(all)));
    hint = told_of_bent_walls(all);
    return hint.empty() ? std::move(planes) : std::move(all);
  }

  Modeller modeller() const {
    Params params;
    Modeller made = make_modeller(model_method, params);
    model_settings.apply(params.get());
    return made;
  }

  static bool is_empty(const Segmentation& segmentation) {
    Fields fields;
    must(jalon_segmentation_segments(segmentation.get(), Out(fields)));
    uint64_t count = 0;
    values<uint32_t>(fields, "label", &count);
    return count == 0;
  }

  // Beside the model, which leaves a processor idle now and then: the cloud with its planes is known before it.
  static void write_segments(const Segmentation& segmentation, OutputFolder& folder,
                             Beside& beside) {
    auto labelled = std::make_shared<Cloud>();
    must(jalon_segmentation_cloud(segmentation.get(), Out(*labelled)));
    const std::string ply = folder.path("segments.ply"), las = folder.path("segments.las");
    beside.run([labelled, ply, las](jalon_task* task) {
      for (const std::string& path : {ply, las})
        must(jalon_cloud_write(labelled->get(), path.c_str(), nullptr, task));
    });
  }

  std::vector<std::string> write(const Console& console, const Segmentation& segmentation,
                                 const Model& model, Json notes, OutputFolder& folder,
                                 Beside& beside) const {
    auto names = files.write(console, segmentation.get(), model.get(), input.path, folder);
    notes["times"]["write"] = console.seconds();
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    must(jalon_report_write_html(segmentation.get(), model.get(), text.c_str(),
                                 folder.path("report.html").c_str(), viewer.params("report").get(),
                                 console.task()));
    must(jalon_report_write_json(segmentation.get(), model.get(), text.c_str(),
                                 folder.path("report.json").c_str(), nullptr, console.task()));
    beside.wait();
    folder.commit();
    names.insert(names.begin(), {"report.html", "report.json"});
    names.insert(names.end(), {"segments.las", "segments.ply"});
    return names;
  }

  Json planes(const Console& console, const Segmentation& segmentation,
              const Lengths& lengths) const {
    Fields fields;
    must(jalon_segmentation_segments(segmentation.get(), Out(fields)));
    uint64_t count = 0;
    const auto* label = values<uint32_t>(fields, "label", &count);
    const auto* orientation = values<uint8_t>(fields, "orientation");
    const auto* inliers = values<uint64_t>(fields, "inliers");
    const auto* normal = values<double>(fields, "normal");
    const auto* offset = values<double>(fields, "offset");
    const auto* sigma = values<double>(fields, "sigma");
    const auto* front_source = values<uint8_t>(fields, "front_source");
    const auto* front_confidence = values<double>(fields, "front_confidence");
    const auto* area = values<double>(fields, "area");
    Json list = Json::array();
    console.say("plane  orientation     points " + lengths.heading("area", "m2", 10) +
                lengths.heading("sigma", "mm", 11) + "   normal");
    for (uint64_t i = 0; i < count; ++i) {
      list.push_back({{"label", label[i]},
                      {"orientation", orientation_name(orientation[i])},
                      {"inliers", inliers[i]},
                      {"area_m2", area[i]},
                      {"sigma_m", sigma[i]},
                      {"offset_m", offset[i]},
                      {"normal", {normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]}},
                      {"front_source", front_name(front_source[i])},
                      {"front_confidence", front_confidence[i]}});
      char line[200];
      std::snprintf(line, sizeof line, "%5u  %-11s %10s %10s %10s   %s %s %s", label[i],
                    orientation_name(orientation[i]), grouped(inliers[i]).c_str(),
                    fixed(area[i], 2).c_str(), lengths.fine(sigma[i], 1).c_str(),
                    fixed(normal[3 * i], 4).c_str(), fixed(normal[3 * i + 1], 4).c_str(),
                    fixed(normal[3 * i + 2], 4).c_str());
      console.say(line);
    }
    return list;
  }

  void run() const {
    Console console(common);
    Json notes{{"title", "Facade"}, {"input", {{"file", input.path}}}, {"times", Json::object()}};
    check_output_folder(output);
    const Segmenter planes_of = segmenter();
    const Modeller model_of = modeller();
    files.check();
    console.step("reading");
    const Cloud cloud = input.read(console);
    notes["times"]["read"] = console.seconds();
    files.note_scanner(cloud.get(), notes);
    const Lengths lengths = Lengths::of(input, cloud);
    notes["input"]["unit"] = lengths.in_report();
    notes["input"]["points"] = grouped(count_of(cloud));
    console.step("planes");
    std::string hint;
    const Segmentation segmentation = surfaces(console, cloud, planes_of, hint);
    if (is_empty(segmentation))
      found_nothing(input, cloud, "no plane", "--tolerance, --segment-set");
    if (const std::string why = why_no_facade(cloud, segmentation); !why.empty())
      throw Failure{JALON_ERROR_DEGENERATE, input.path + ": " + why};
    notes["times"]["segment"] = console.seconds();
    console.step("model");
    keep_large_blocks();  // finding planes needs the most
    OutputFolder folder(output);
    Beside beside(console);
    write_segments(segmentation, folder, beside);
    Model model;
    must(jalon_modeller_run(model_of.get(), cloud.get(), segmentation.get(), console.task(),
                            Out(model)));
    const Json summary = summary_of(model.get());
    if (summary["faces"] == 0) found_nothing(input, cloud, "planes, but no face", "--model-set");
    if (!hint.empty()) console.warn(hint);
    notes["times"]["model"] = console.seconds();
    console.step("writing");
    const auto names = write(console, segmentation, model, notes, folder, beside);
    const Json list = planes(console, segmentation, lengths);
    console.say(summary_line(summary));
    console.say("wrote " + output + ": " + joined(names));
    for (const std::string& note :
         {noise_note(planes_of.get(), segmentation.get(), lengths), front_note(segmentation.get())})
      if (!note.empty()) console.say(note);
    if (!lengths.is_known()) console.say(lengths.note());
    console.result({{"input", input.path},
                    {"points", count_of(cloud)},
                    {"output", output},
                    {"times", notes["times"]},
                    {"planes", list},
                    {"model", summary},
                    {"files", names}});
  }
};

std::string tables_of_facade() {
  Params planes;
  make_segmenter("ransac", planes);
  return "Parameters of --segment-set (or --set; planes):\n" + describe(planes.get()) + "\n" +
         modeller_tables("--model-set") + "Parameters of --drawing-set:\n" +
         describe(make_params("elevation").get()) + "\nParameters of --orthoimage-set:\n" +
         describe(make_params("orthoimage").get()) +
         "\nParameters of --scanner-set (precision of the scanner):\n" +
         describe(make_params("precision").get());
}

}  // namespace

void add_facade(Command& app) {
  Command command = app.subcommand(
      "facade", "From a scan to planes, a model with windows and doors, a drawing and a report");
  auto state = std::make_shared<Facade>();
  state->input.add_to(command);
  add_output_folder(command, state->output);
  command
      .option("--tolerance", state->tolerance_m,
              "Half-thickness of a plane (m); default: the segmenter's")
      .positive();
  state->settings.add_to(command, "segment-");
  state->settings.add_short_to(command);
  command
      .option("--model-method", state->model_method,
              "How the model is made; the parameters below tell which methods there are")
      .shows_default()
      .type_name("NAME");
  state->model_settings.add_to(command, "model-");
  state->files.add_to(command);
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return tables_of_facade() +
           "\nExamples:\n  jalon facade scan.las -o result\n"
           "  jalon facade scan.txt -o result --columns \"x y z intensity\" --segment-set seed=7";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
