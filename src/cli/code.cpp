// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/inputs/coded_list.h"
#include "cli/model_files.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/outputs/json_csv.h"
#include "cli/outputs/target_list.h"
#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kModelFiles[] = {"model.dxf", "model.city.json", "model.geojson"};

// Objects or targets on the screen; all of them stand in the CSV file.
constexpr size_t kMostListed = 20;

std::string words(const Json& list) {
  std::string out;
  for (const Json& each : list)
    out += (out.empty() ? "" : " ") + (each.is_string() ? each.get<std::string>() : each.dump());
  return out;
}

/// A row an object; the two places are the corners of an opening or the ends of an axis.
std::string coded_objects_csv(const Json& objects) {
  std::string out =
      "object,name,kind,code,class,label,points,shape,hinge,radius_m,x1,y1,z1,x2,y2,z2,ids,lines,"
      "codes\n";
  size_t number = 0;
  for (const Json& o : objects) {
    const auto text = [&](const char* name) {
      if (!o.contains(name)) return std::string();
      return csv_cell(o[name].is_string() ? o[name].get<std::string>() : o[name].dump());
    };
    out += std::to_string(++number);
    for (const char* name :
         {"name", "kind", "code", "class", "label", "points", "shape", "hinge", "radius_m"})
      out += "," + text(name);
    const char* places = o.contains("corners") ? "corners" : "axis";
    for (const bool last : {false, true})
      for (size_t k = 0; k < 3; ++k)
        out += "," +
               (o.contains(places) ? (last ? o[places].back() : o[places].front())[k].dump() : "");
    out +=
        "," + csv_cell(words(o["ids"])) + "," + words(o["lines"]) + "," + words(o["codes"]) + "\n";
  }
  return out;
}

std::string code_warnings_csv(const Json& warnings) {
  std::string out = "line,object,warning\n";
  for (const Json& w : warnings)
    out += w["line"].dump() + "," + csv_cell(w["object"]) + "," + csv_cell(w["text"]) + "\n";
  return out;
}

/// What is most likely wrong with a list without objects.
std::string first_warning(const Json& warnings) {
  if (warnings.empty()) return "";
  const Json& first = warnings.front();
  return "; line " + first["line"].dump() + ": " + first["object"].get<std::string>() + ": " +
         first["text"].get<std::string>() +
         (warnings.size() > 1 ? ", and " + grouped(warnings.size() - 1) + " more" : "");
}

/// Classes and the first objects.
void list_coded(const Console& console, const Json& notes) {
  for (const Json& c : notes["classes"])
    console.say("class " + c["class"].dump() + ": " + grouped(c["points"]) + " points");
  size_t listed = 0;
  for (const Json& o : notes["objects"]) {
    if (++listed > kMostListed) break;
    console.say(o["name"].get<std::string>() + ": " + o["shape"].get<std::string>() + ", " +
                grouped(o["points"]) + " points");
  }
  if (notes["objects"].size() > kMostListed)
    console.say("... " + grouped(notes["objects"].size()) + " objects in objects.csv");
}

/// "step walls: 1.5 s" of the log as {"walls": 1.5}; other lines are none.
void add_step_times(const std::vector<std::string>& told, Json& times_s) {
  constexpr const char* kStep = "step ";
  for (const std::string& line : told) {
    const size_t colon = line.rfind(": "), end = line.rfind(" s");
    if (!line.starts_with(kStep) || colon == std::string::npos || end <= colon) continue;
    const Json seconds =
        Json::parse(line.substr(colon + 2, end - colon - 2), nullptr, /*allow_exceptions=*/false);
    if (seconds.is_number()) times_s[line.substr(5, colon - 5)] = seconds;
  }
}

const char* method_name(const std::string& method) {
  return method == "targets" ? "target_codes" : "survey_codes";
}

std::string parameters_of(const char* method) {
  Segmenter segmenter;
  Params params;
  must(jalon_segmenter_create(method_name(method), Out(segmenter)));
  must(jalon_segmenter_params(segmenter.get(), Out(params)));
  return std::string("Parameters of --set with --method ") + method + ":\n" +
         describe(params.get()) + "\n";
}

void set_from_file(jalon_params* params, const char* name, const std::string& path) {
  if (jalon_params_set_string(params, name, read_code_file(path).c_str()) != JALON_OK)
    throw Failure{JALON_ERROR_FORMAT,
                  path + ": " + jalon_last_error_message() + "; save the file as UTF-8"};
}

struct Code {
  Common common;
  Input input;
  Settings settings, model_settings;
  ViewerOption viewer;
  std::string codes, table, output, method;

  Segmenter segmenter(Params& params) const {
    Segmenter made;
    must_know(jalon_segmenter_create(method_name(method), Out(made)));
    must(jalon_segmenter_params(made.get(), Out(params)));
    settings.apply(params.get());
    set_from_file(params.get(), "codes", codes);
    if (!table.empty()) set_from_file(params.get(), "table", table);
    return made;
  }

  Modeller modeller() const {
    Params params;
    Modeller made = make_modeller("coded_objects", params);
    model_settings.apply(params.get());
    return made;
  }

  std::vector<std::string> write(const Console& console, const Segmentation& segmentation,
                                 const Model& model, const Json& result, const Json& notes) const {
    OutputFolder folder(output);
    const auto path = [&](const char* name) { return folder.path(name); };
    Cloud classified;
    must(jalon_segmentation_cloud(segmentation.get(), Out(classified)));
    must(jalon_cloud_write(classified.get(), path("classified.las").c_str(), nullptr,
                           console.task()));
    for (const char* name : kModelFiles)
      must(jalon_model_write(model.get(), path(name).c_str(), nullptr, console.task()));
    const Params plan = make_params("picture");
    must(jalon_params_set_string(plan.get(), "view", "plan"));
    must(jalon_report_write_picture(segmentation.get(), path("plan.svg").c_str(), plan.get(),
                                    console.task()));
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    must(jalon_report_write_html(segmentation.get(), model.get(), text.c_str(),
                                 path("report.html").c_str(), viewer.params("report").get(),
                                 console.task()));
    write_text_file(path("objects.csv"), coded_objects_csv(result["objects"]));
    write_text_file(path("warnings.csv"), code_warnings_csv(result["warnings"]));
    write_text_file(path("codes.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    folder.commit();
    std::vector<std::string> names{"report.html", "plan.svg"};
    names.insert(names.end(), std::begin(kModelFiles), std::end(kModelFiles));
    names.insert(names.end(), {"classified.las", "objects.csv", "warnings.csv", "codes.json"});
    return names;
  }

  void run() const {
    Console console(common);
    check_output_folder(output);
    Params params;
    const Segmenter worker = segmenter(params);  // wrong parameters are told before a long read
    const Modeller model_of = modeller();
    Json times = Json::object();
    console.step("reading");
    const Cloud cloud = input.read(console);
    times["read"] = console.seconds();
    require_near(codes, params, cloud);
    console.step("codes");
    Segmentation segmentation;
    must(jalon_segmenter_run(worker.get(), cloud.get(), console.task(), Out(segmentation)));
    times["segment"] = console.seconds();
    Json steps{{"read", times["read"]}};  // of the page: the steps in the place of their sum
    add_step_times(console.told(), steps);
    const char* text = nullptr;
    must(jalon_segmentation_notes(segmentation.get(), &text));
    const Json notes = Json::parse(text);
    if (notes["objects"].empty())
      throw Failure{JALON_ERROR_INSUFFICIENT_DATA,
                    codes + ": no object in these codes" + first_warning(notes["warnings"])};
    console.step("model");
    Model model;
    must(jalon_modeller_run(model_of.get(), cloud.get(), segmentation.get(), console.task(),
                            Out(model)));
    times["model"] = steps["model"] = console.seconds();
    const Json summary = summary_of(model.get());
    Json result{{"input", input.path}, {"codes", codes},   {"points", count_of(cloud)},
                {"output", output},    {"times_s", times}, {"steps", console.told()},
                {"model", summary}};
    result.update(notes);
    console.step("writing");
    const auto names = write(console, segmentation, model, result,
                             {{"title", "Feature codes"},
                              {"input", {{"scan", input.path}, {"codes", codes}}},
                              {"times", steps}});
    list_coded(console, notes);
    const char* form = nullptr;
    must(jalon_params_get_string(params.get(), "form", &form));
    if (form == std::string("source"))
      console.say("by the published method; --set form=improved looks for what it leaves over");
    console.say(summary_line(summary));
    console.say("wrote " + output + ": " + joined(names));
    console.result(result);
  }
};

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
    const Json rows = target_rows_of(table, Json::parse(text));
    Json counts{{"known", 0}, {"ambiguous", 0}, {"foreign", 0}, {"uncertain", 0}};
    for (const Json& row : rows) {
      Json& count = counts[row["verdict"].get<std::string>()];
      count = count.get<int>() + 1;
    }
    const Json result{{"input", input.path},
                      {"catalogue", catalogue},
                      {"output", output},
                      {"counts", counts},
                      {"targets", rows}};
    OutputFolder folder(output);
    write_text_file(folder.path("targets.csv"), csv_of(rows));
    write_text_file(folder.path("targets.txt"), target_code_lines(rows));
    write_text_file(folder.path("targets.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    folder.commit();
    for (size_t i = 0; i < std::min<size_t>(rows.size(), kMostListed); ++i)
      console.say(target_line(rows[i]));
    if (rows.size() > kMostListed)
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
  add_output_folder(command, state->output);
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

void add_code(Command& app) {
  Command command =
      app.subcommand("code", "From a scan and a list of coded points to classified objects");
  auto state = std::make_shared<Code>();
  state->input.add_to(command);
  command.option("codes", state->codes, "Coded points, a line each: ID;X;Y;Z;code")
      .required()
      .type_name("CODES");
  add_output_folder(command, state->output);
  command
      .option("--method", state->method,
              "How the objects were coded: by targets on them or by a total station")
      .among({"survey", "targets"})
      .required();
  command.option("--table", state->table, "Code table (JSON) in the place of the method's own")
      .type_name("FILE");
  state->settings.add_to(command);
  state->model_settings.add_to(command, "model-");
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    Params objects;
    make_modeller("coded_objects", objects);
    return parameters_of("survey") + parameters_of("targets") +
           "Parameters of --model-set (coded objects):\n" + describe(objects.get()) + "\n" +
           R"(classified.las has the class of every point, in the scan's order: 0 rest, 1 walls, 2 doors, 3 windows,
4 gutters, or those of the code table. form=source (the default) is the published method;
form=improved finds frames, leaves and gutters where their points lie, better in every class.
model.* has the objects with their codes: buildings as prisms with their openings, gutters as pipes;
report.html and plan.svg show them over the points in the colours of their classes. Unknown codes,
incomplete or empty objects and points far from the scan are warnings that name line and object.

Examples:
  jalon code scan.las survey.txt -o result --method survey
  jalon code scan.las targets.txt -o result --method targets --set window_margin_m=0.1
  jalon code scan.las survey.txt -o result --method survey --table my_codes.json --set inward_m=0.3
  jalon evaluate-segmentation result/classified.las truth.las --classes-only --class-field classification \
    --reference-class-field classification)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
