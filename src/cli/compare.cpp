// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/comparing/direction.h"
#include "cli/comparing/extras.h"
#include "cli/comparing/field_steps.h"
#include "cli/comparing/later_fields.h"
#include "cli/comparing/report_files.h"
#include "cli/inputs/compare_inputs.h"
#include "cli/outputs/compare_listing.h"
#include "cli/lengths.h"
#include "cli/methods.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/inputs/registration_file.h"
#include "cli/system/memory.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Compare {
  ViewerOption viewer;
  Common common;
  Settings settings, change_settings, sample_settings;
  Input reference, compared, core;
  std::string method = "distance", registration, m3c2_file, output;
  std::string box;  ///< of all scans
  Extras extras;
  FieldSteps steps;
  double threshold_m = 0;  ///< 0 = the operation's default
  bool is_one_way = false, is_forced = false;

  /// A file read: a scan, or a model and points on it.
  struct Epoch : ReadScan {
    Model model;
    Lengths lengths;
    jalon_box box{};
  };

  Epoch read(Console& console, const Input& input, bool with_points, bool is_lean) const {
    Epoch out;
    if (!is_model_file(input.path)) {
      static_cast<ReadScan&>(out) =
          is_lean ? read_to_compare(console, input) : ReadScan{input.read(console)};
      out.lengths = Lengths::of(input, out.cloud);
      out.box = box_of(out.cloud);
      return out;
    }
    if (input.is_told())
      throw Failure{
          JALON_ERROR_INVALID_ARGUMENT,
          input.path + " is a model: unit, columns, station, box and the like are of a scan"};
    must_read(jalon_model_read(input.path.c_str(), nullptr, console.task(), Out(out.model)));
    out.lengths = Lengths::of(input.path, out.model);
    out.box = box_of(out.model);
    if (with_points) out.cloud = sampled(console, out.model, sample_settings);
    return out;
  }

  // Models have faces, and a scan compared with them has no way back: the scan's points are not all of the model.
  Direction run_to(Console& console, const Comparer& worker, const Epoch& from,
                   const Epoch& to) const {
    if (from.model == nullptr) return run_one(console, worker, from.cloud, to.cloud);
    if (!core.path.empty())
      throw Failure{JALON_ERROR_UNSUPPORTED, "--core is for two scans, not for a model"};
    return run_model(console, worker, from.model, to.cloud);
  }

  Comparer comparer(const Console& console, Params& params) const {
    Comparer made;
    must_know(jalon_comparer_create(method.c_str(), Out(made)));
    must(jalon_comparer_params(made.get(), Out(params)));
    if (!m3c2_file.empty())
      must_read(jalon_comparer_read_m3c2_file(made.get(), m3c2_file.c_str(), console.task()));
    if (!registration.empty()) use_registration_file(registration, params.get());
    settings.apply(params.get());
    return made;
  }

  Params change_options(const char* operation) const {
    Params options = make_params(operation);
    if (threshold_m > 0) {
      must(jalon_params_set_double(options.get(), "threshold_m", threshold_m));
      if (method == "distance")
        must(jalon_params_set_string(options.get(), "criterion", "threshold"));
    }
    change_settings.apply(options.get());
    return options;
  }

  static Direction run_model(const Console& console, const Comparer& worker, const Model& from,
                             const Cloud& to) {
    Comparison made;
    must(jalon_comparer_run_model(worker.get(), from.get(), to.get(), console.task(), Out(made)));
    return Direction::of(std::move(made));
  }

  Direction run_one(Console& console, const Comparer& worker, const Cloud& from,
                    const Cloud& to) const {
    Comparison made;
    if (core.path.empty())
      must(jalon_comparer_run(worker.get(), from.get(), to.get(), console.task(), Out(made)));
    else
      must(jalon_comparer_run_core(worker.get(), from.get(), to.get(), core.read(console).get(),
                                   console.task(), Out(made)));
    return Direction::of(std::move(made));
  }

  // How the two sides are compared.
  struct Plan {
    bool both = false;       ///< each with the other
    bool diagnosed = false;  ///< two scans both ways: changes have classes
    bool by_models = false;  ///< two models by points on them
    std::string shadows;     ///< what became of the parts that a scan could not see
  };

  void write_report(const Console& console, const PathOf& path_of, const Direction& forward,
                    const Direction& reverse, const Fields& changes, const Params& change_options,
                    const Json& times, const Plan& plan, const Lengths& lengths) const {
    const Params options = viewer.params("comparison_report");
    must(jalon_params_set_double(options.get(), "threshold_m",
                                 deciding_threshold(*forward.summary, change_options)));
    Json notes{
        {"title", "Comparison"},
        {"input", {{"reference", reference.path}, {"compared", compared.path}, {"method", method}}},
        {"times", times}};
    if (!plan.shadows.empty()) notes["input"]["shadows"] = plan.shadows;
    notes["input"]["unit"] = lengths.in_report();
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    write_report_files(console, path_of, {forward, reverse, changes, plan.diagnosed}, options,
                       text);
  }

  Plan plan() const {
    Plan out;
    const bool from_model = is_model_file(reference.path), to_model = is_model_file(compared.path);
    out.by_models = from_model && to_model;
    out.diagnosed = !is_one_way && method == "distance" && !from_model && !to_model;
    out.both = out.diagnosed || (out.by_models && !is_one_way);
    return out;
  }

  // Do only distances and their diagnosis count, which need no fields of the points?
  bool may_wait_for_fields(const Plan& plan, const Params& change_options) const {
    const char* criterion = nullptr;
    must(jalon_params_get_string(change_options.get(), "criterion", &criterion));
    return plan.diagnosed && !steps.is_given() && !extras.is_given() &&
           std::string(criterion) != "field";
  }

  Fields find_changes(const Console& console, const Plan& plan, const Params& options,
                      Direction& forward, Direction& reverse) const {
    Fields found;
    if (plan.diagnosed) {
      must(jalon_comparison_diagnose(forward.comparison.get(), reverse.comparison.get(),
                                     options.get(), console.task(), Out(forward.points),
                                     Out(reverse.points), Out(found)));
      return found;
    }
    must(jalon_comparison_regions(forward.comparison.get(), options.get(), console.task(),
                                  Out(forward.points), Out(found)));
    if (plan.both)
      must(jalon_comparison_regions(reverse.comparison.get(), options.get(), console.task(),
                                    Out(reverse.points), nullptr));
    return found;
  }

  Json result_of(const Plan& plan, const Params& params, const Params& options, const Json& times,
                 const Direction& forward, const Direction& reverse) const {
    const char *parameters = nullptr, *change_parameters = nullptr;
    must(jalon_params_to_json(params.get(), &parameters));
    must(jalon_params_to_json(options.get(), &change_parameters));
    Json result{{"reference", reference.path},
                {"compared", compared.path},
                {"output", output},
                {"method", method},
                {"parameters", Json::parse(parameters)},
                {"change_parameters", Json::parse(change_parameters)},
                {"times", times},
                {"summary", forward.summary->object(0)}};
    if (plan.both) result["reverse_summary"] = reverse.summary->object(0);
    if (plan.by_models && plan.both) {
      const double there = forward.summary->number("maximum_absolute", 0);
      const double back = reverse.summary->number("maximum_absolute", 0);
      result["hausdorff"] = {
          {"forward", there}, {"reverse", back}, {"symmetric", std::max(there, back)}};
    }
    return result;
  }

  void say(const Console& console, const Plan& plan, const Direction& forward,
           const Direction& reverse, const Table& changes, const Json& result,
           const Lengths& lengths) const {
    say_summary(console, plan.both ? "compared with the reference" : "compared", *forward.summary,
                lengths);
    if (plan.both) say_summary(console, "reference with the compared", *reverse.summary, lengths);
    if (result.contains("hausdorff"))
      console.say(
          "Hausdorff distance: " + fixed(result["hausdorff"]["symmetric"].get<double>(), 4) + " " +
          lengths.length());
    if (!plan.shadows.empty()) console.say("shadows: " + plan.shadows);
    plan.diagnosed ? list_changes(console, changes, lengths)
                   : list_regions(console, changes, lengths);
    if (forward.summary->has("depletion")) say_landslide(console, *forward.summary, lengths);
    extras.say(console, result, lengths);
    console.say("wrote " + output +
                ": report.html, comparison.json, histogram.svg, distances.svg, " +
                (plan.diagnosed ? "changes" : "regions") +
                ".csv, regions.geojson, regions.dxf, compared.las, compared.ply" +
                (plan.both ? ", reference.las, reference.ply" : ""));
    if (!lengths.is_known()) console.say(lengths.note());
    console.result(result);
  }

  void run() const {
    Console console(common);
    Params params;
    check_output_folder(output);
    const Comparer worker =
        comparer(console, params);  // wrong parameters are told before a long read
    Plan plan = this->plan();
    extras.check(is_model_file(reference.path), is_model_file(compared.path), method);
    steps.check();
    const Params options = change_options(plan.diagnosed ? "diagnosis" : "regions");
    console.step("reading");
    const bool is_lean = may_wait_for_fields(plan, options);
    const Epoch after = read(console, compared, true, is_lean),
                before = read(console, reference, plan.both, is_lean);
    const bool of_scans = method == "distance" && before.model == nullptr && after.model == nullptr;
    if (of_scans) choose_for_scans(before.cloud, after.cloud, plan.both, settings, params);
    Json times{{"read", console.seconds()}};
    const Lengths lengths = before.lengths.with(after.lengths);
    refuse_apart(console, {reference, where(console, before.model, before.cloud)},
                 {compared, where(console, after.model, after.cloud)}, is_forced);
    warn_of_sizes(console, reference.path, before.box, compared.path, after.box);
    console.step("comparing");
    Direction forward = run_to(console, worker, before, after), reverse;
    if (plan.both) reverse = run_to(console, worker, after, before);
    require_compared(reference.path, compared.path, forward, reverse);
    warn_of_misalignment(console, *forward.summary);
    const Json third = extras.use_third_epoch(console, worker.get(), after.cloud, forward);
    if (of_scans)
      plan.shadows = said_of_shadows(before.cloud, params, *forward.summary,
                                     plan.both ? reverse.summary.get() : nullptr);
    times["compare"] = console.seconds();
    give_back_memory();
    console.step("changes");
    Fields found = find_changes(console, plan, options, forward, reverse);
    times["changes"] = console.seconds();
    console.step("writing");
    OutputFolder folder(output);
    const PathOf path_of = [&](const std::string& name) { return folder.path(name); };
    write_report(console, path_of, forward, reverse, found, options, times, plan, lengths);
    // The last that asks for neighbours: what writing points takes lies where the indices were.
    for (const Cloud* cloud : {&after.cloud, &before.cloud})
      if (*cloud) must(jalon_cloud_drop_index(cloud->get()));
    give_back_memory();
    Beside beside(console);
    Json done = Json::array();
    if (steps.is_given()) {
      Cloud points = forward.cloud();
      done = steps.run(console, points, before.cloud);
      write_both(beside, path_of, std::move(points), "compared");
    } else {
      write_points(console, beside, path_of, "compared", compared, after, forward);
    }
    beside.wait();  // the points of one side with all that they tell are in memory at a time
    if (plan.both) write_points(console, beside, path_of, "reference", reference, before, reverse);
    beside.wait();
    const Table changes(std::move(found));
    const std::string list = plan.diagnosed ? "changes" : "regions";
    write_text_file(folder.path(list + ".csv"), changes.csv());
    Json result = result_of(plan, params, options, times, forward, reverse);
    result[list] = changes.list();
    if (!third.is_null()) result["third_epoch"] = third;
    if (!done.empty()) result["then"] = std::move(done);
    extras.write(console, path_of, {before.model, before.cloud}, {after.model, after.cloud},
                 forward, result);
    write_text_file(folder.path("comparison.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    folder.commit();
    say(console, plan, forward, reverse, changes, result, lengths);
  }
};

std::string tables_of_compare() {
  return method_tables<Comparer>("Parameters of --set with --method ", jalon_comparer_methods,
                                 jalon_comparer_create, jalon_comparer_params) +
         "Parameters of --change-set:\n" + describe(make_params("diagnosis").get()) +
         "\nParameters of --sample-set, for a model on the compared side or two models:\n" +
         describe(make_params("model_sample").get()) + "\n" + Extras::tables() +
         FieldSteps::tables();
}

}  // namespace

void add_compare(Command& app) {
  Command command = app.subcommand(
      "compare", "Two scans, a model and a scan, or two models: distances and changes");
  auto state = std::make_shared<Compare>();
  command
      .option("reference", state->reference.path,
              "The scan (before) or the model (.obj, .stl, .json) that distances are taken from")
      .required()
      .type_name("REFERENCE");
  command
      .option(
          "compared", state->compared.path,
          "The scan whose points get them (after), or a model, which gives points on its surfaces")
      .required()
      .type_name("COMPARED");
  add_output_folder(command, state->output);
  command
      .option("--method", state->method,
              "How distances are measured; the parameters below tell which there are")
      .shows_default()
      .type_name("NAME");
  command
      .option(
          "--registration", state->registration,
          "registration.json of \"jalon register\": its covariance joins m3c2's level of detection")
      .type_name("FILE");
  command
      .option("--core", state->core.path,
              "Scan file of m3c2's core points: where its distances are measured")
      .type_name("SCAN");
  command
      .option(
          "--m3c2-file", state->m3c2_file,
          "Parameter file of CloudCompare's M3C2 plug-in, for method m3c2; --set goes before it")
      .type_name("FILE");
  command.option("--threshold", state->threshold_m, "Distance (m) above which a point has changed")
      .positive();
  command.flag("--one-way", state->is_one_way,
               "Only the compared side with the reference: regions instead of classes of changes");
  command.flag("--force", state->is_forced,
               "Compare them even where they hardly share a place, which ends the command with 5");
  add_reading_of_two(command, state->reference, "reference-", state->compared, "compared-");
  command
      .option("--box", state->box,
              "Read the points of this box alone of all scans that no box of their own is told for")
      .type_name("X,Y,Z,X,Y,Z");
  state->settings.add_to(command);
  state->change_settings.add_to(command, "change-");
  state->sample_settings.add_to(command, "sample-");
  state->extras.add_to(command);
  state->steps.add_to(command);
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Two scans are compared with detection=true, unless --set or --params say otherwise: "
           "distances from the surfaces\n"
           "of the other scan, each tested against noise, spacing and shape at a rate of false "
           "discoveries. What the\n"
           "scanners could not see is no change: they stood where the files or "
           "--reference-station and\n"
           "--compared-station say, else where the order of the points tells (visibility=found). "
           "Without stations\n"
           "shadows may show as changes. --threshold asks for larger changes than the significant "
           "ones.\n\n" +
           tables_of_compare() +
           "Examples:\n  jalon compare march.las april.las -o changes\n"
           "  jalon compare march.las april.las -o changes --one-way --threshold 0.02 --set "
           "max_distance_m=1\n"
           "  jalon compare model.city.json scan.las -o as_built --set tolerance_m=0.01\n"
           "  jalon compare planned.obj built.obj -o models --sample-set spacing_m=0.02\n"
           "  jalon compare march.las april.las -o creep --method m3c2 --set core_spacing_m=0.5\n"
           "  jalon compare before.e57 after.e57 -o slide --method landslide\n"
           "  jalon compare march.las april.las -o pit --volumes --volume-set cell_m=0.5\n"
           "  jalon compare march.las april.las -o tools --then classes --then \"noise_law "
           "law=gauss\" "
           "--then chi_square";
  });
  command.on_run([state] {
    use_box(state->box,
            {&state->reference, &state->compared, &state->core, &state->extras.third()});
    state->run();
  });
}

}  // namespace jalon::cli
