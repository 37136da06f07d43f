// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Adjust {
  ViewerOption viewer;
  Common common;
  Settings settings, strip_settings, trajectory_settings;
  Input cloud;
  std::string model, trajectory, sigmas, truth, output;

  // What was read.
  struct Inputs {
    Model strips;
    Cloud cloud;
    Trajectory trajectory, truth;
  };

  // Roofs and ground come along unless told otherwise: they hide walls.
  Params strip_options() const {
    Params options = make_params("building_strips");
    must(jalon_params_set_bool(options.get(), "others", 1));
    strip_settings.apply(options.get());
    return options;
  }

  Inputs read(Console& console, const Params& strips, const Params& drive) const {
    Inputs made;
    Model buildings;
    must_read(jalon_model_read(model.c_str(), nullptr, console.task(), Out(buildings)));
    must(jalon_model_building_strips(buildings.get(), strips.get(), console.task(),
                                     Out(made.strips), nullptr));
    must_read(jalon_trajectory_read(trajectory.c_str(), sigmas.empty() ? nullptr : sigmas.c_str(),
                                    drive.get(), console.task(), Out(made.trajectory)));
    if (!truth.empty())
      must_read(
          jalon_trajectory_read(truth.c_str(), nullptr, nullptr, console.task(), Out(made.truth)));
    made.cloud = cloud.read(console);
    return made;
  }

  template <class F>
  static Table table(const Adjustment& adjustment, F&& read) {
    Fields fields;
    must(read(adjustment.get(), Out(fields)));
    return Table(std::move(fields));
  }

  void write(const Console& console, OutputFolder& folder, const Adjustment& made,
             const Inputs& inputs) const {
    Trajectory drive;
    Model strips;
    Cloud points;
    must(jalon_adjustment_trajectory(made.get(), Out(drive)));
    must(jalon_adjustment_model(made.get(), Out(strips)));
    must(jalon_adjustment_apply(made.get(), inputs.cloud.get(), console.task(), Out(points)));
    must(jalon_trajectory_write(drive.get(), folder.path("trajectory.txt").c_str(), nullptr,
                                nullptr, console.task()));
    for (const char* name : {"model.obj", "model.city.json"})
      must(jalon_model_write(strips.get(), folder.path(name).c_str(), nullptr, console.task()));
    for (const char* name : {"cloud.las", "cloud.ply"})
      must(jalon_cloud_write(points.get(), folder.path(name).c_str(), nullptr, console.task()));
    write_text_file(folder.path("controls.csv"), table(made, jalon_adjustment_controls).csv());
    write_text_file(folder.path("blocks.csv"), table(made, jalon_adjustment_blocks).csv());
    write_text_file(folder.path("facades.csv"), table(made, jalon_adjustment_facades).csv());
    write_text_file(folder.path("strips.csv"), table(made, jalon_adjustment_strips).csv());
    write_text_file(folder.path("matches.csv"), table(made, jalon_adjustment_matches).csv());
  }

  // Few matches settle as well as many do.
  static void warn_of_few_matches(const Console& console, const Adjustment& made) {
    constexpr uint64_t kFew = 10;  // one in so many
    const Table passes = table(made, jalon_adjustment_iterations);
    const uint64_t last = passes.rows() - 1, far = passes.count("far", last),
                   nothing = passes.count("nothing", last), matched = passes.count("matched", last),
                   all = table(made, jalon_adjustment_summary).count("points", 0);
    if (kFew * matched < all)
      console.warn("only " + grouped(matched) + " of " + grouped(all) +
                   " points that look like a wall's are on one, " + grouped(far) +
                   " too far from it and " + grouped(nothing) +
                   " meet none: are model and drive in one unit and coordinate system, z up, and "
                   "off by no more than their sigmas?");
    else if (far > matched)
      console.warn(grouped(far) + " points met a wall and are too far from it, more than the " +
                   grouped(matched) +
                   " that are on one: are model or drive off by more than their sigmas?");
  }

  // Poses on the straight line across a gap look like any others.
  static void warn_of_gaps(const Console& console, const Trajectory& drive) {
    constexpr double kLeast_s = 1;  // as control times are apart: so long a drive keeps its way
    constexpr double kOver = 10;    // usual steps
    Fields fields;
    must(jalon_trajectory_epochs(drive.get(), Out(fields)));
    const Table epochs(std::move(fields));
    std::vector<double> steps;
    for (uint64_t i = 1; i < epochs.rows(); ++i)
      steps.push_back(epochs.number("time", i) - epochs.number("time", i - 1));
    if (steps.empty()) return;
    std::vector<double> sorted = steps;
    std::ranges::nth_element(sorted,
                             sorted.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
    const double least = std::max(kLeast_s, kOver * sorted[steps.size() / 2]);
    const auto gaps = std::ranges::count_if(steps, [&](double step) { return step > least; });
    if (gaps == 0) return;
    const auto longest = std::ranges::max_element(steps);
    const auto at = static_cast<uint64_t>(longest - steps.begin());
    console.warn(
        "the trajectory has no epochs for " + fixed(*longest, 2) + " s from " +
        fixed(epochs.number("time", at), 2) + " s on" +
        (gaps > 1 ? ", the longest of " + grouped(static_cast<uint64_t>(gaps)) + " gaps" : "") +
        ": it is taken to go straight across, as sure as beside the gap");
  }

  static void say(const Console& console, const Adjustment& made) {
    const Table summary = table(made, jalon_adjustment_summary);
    const auto count = [&](const char* name) { return grouped(summary.count(name, 0)); };
    console.say(std::string(summary.count("converged", 0) != 0 ? "converged" : "not converged") +
                " after " + count("passes") + " passes: " + count("matched") + " of " +
                count("points") + " points on " + count("strips") + " strips, rms " +
                fixed(1000 * summary.number("rms", 0), 1) + " mm");
    const Table controls = table(made, jalon_adjustment_controls);
    double moved = 0, before = 0, after = 0;
    for (uint64_t i = 0; i < controls.rows(); ++i)
      for (uint32_t k = 0; k < 2; ++k) {
        moved = std::max(moved, std::fabs(controls.number("correction", i, k)));
        before += controls.number("prior_sigma", i, k), after += controls.number("sigma", i, k);
      }
    const double n = 2 * static_cast<double>(controls.rows());
    console.say("trajectory: corrected by up to " + fixed(moved, 3) + " m, sigma " +
                fixed(before / n, 3) + " m before, " + fixed(after / n, 3) + " m after");
    if (summary.number("attitude_bias_sigma", 0, 0) + summary.number("attitude_bias_sigma", 0, 1) +
            summary.number("attitude_bias_sigma", 0, 2) >
        0) {
      std::string angles;
      constexpr double kDegree = 57.29577951308232;
      for (uint32_t k = 0; k < 3; ++k)
        angles += std::string(k > 0 ? ", " : " ") +
                  fixed(kDegree * summary.number("attitude_bias", 0, k), 4) + " +- " +
                  fixed(kDegree * summary.number("attitude_bias_sigma", 0, k), 4);
      console.say("roll, pitch, heading: off by" + angles + " degrees");
    }
    if (summary.count("ground_intervals", 0) > 0)
      console.say("heights by the ground: " + count("ground_points") + " points in " +
                  count("ground_intervals") + " intervals, chi-square " +
                  fixed(summary.number("ground_chi_square", 0), 1));
    const double p = summary.number("p_value", 0);
    constexpr double kRare = 0.001;
    console.say("test of the model: chi-square " + fixed(summary.number("chi_square", 0), 1) +
                " on " + count("strips") + ", p " + fixed(p, 4) +
                (p < kRare       ? ": the sigmas are too small, or matches are wrong"
                 : p > 1 - kRare ? ": the sigmas are greater than what is off"
                                 : ""));
    if (summary.count("weak_is_held", 0) == 0)
      console.say("nothing is known along the direction " +
                  fixed(summary.number("weak_direction", 0, 0), 3) + ", " +
                  fixed(summary.number("weak_direction", 0, 1), 3) +
                  ": no wall seen stands across it");
    warn_of_few_matches(console, made);
    if (const uint64_t doubtful = summary.count("doubtful_strips", 0); doubtful > 0)
      console.say(grouped(doubtful) + (doubtful == 1 ? " strip was" : " strips were") +
                  " not adjusted: what is seen may be the wall of another, and nothing "
                  "tells (strips.csv, column doubtful)");
    if (const double wrong = summary.number("wrong_strips", 0); std::isfinite(wrong))
      console.say("of the matches " + fixed(100 * wrong, 2) + " % are on another strip than " +
                  "the cloud's field says, " + fixed(100 * summary.number("wrong_facades", 0), 2) +
                  " % on another facade");
    if (const uint64_t outside = summary.count("outside", 0); outside > 0)
      console.say(grouped(outside) +
                  " points are outside of the trajectory's time and moved as its ends do");
  }

  void run() const {
    Console console(common);
    check_output_folder(output);
    const Params options = make_params("adjust"), strips = strip_options(),
                 drive = make_params("trajectory_file");
    settings.apply(options.get());  // wrong parameters are told before a long read
    trajectory_settings.apply(drive.get());
    console.step("reading");
    const Inputs inputs = read(console, strips, drive);
    warn_of_gaps(console, inputs.trajectory);
    Json times{{"read", console.seconds()}};
    console.step("adjusting");
    Adjustment made;
    must(jalon_trajectory_adjust(inputs.trajectory.get(), inputs.cloud.get(), inputs.strips.get(),
                                 options.get(), console.task(), Out(made)));
    times["adjust"] = console.seconds();
    console.step("writing");
    OutputFolder folder(output);
    write(console, folder, made, inputs);
    const char* parameters = nullptr;
    must(jalon_adjustment_parameters(made.get(), &parameters));
    const Json result{{"model", model},
                      {"cloud", cloud.path},
                      {"trajectory", trajectory},
                      {"output", output},
                      {"parameters", Json::parse(parameters)},
                      {"times", times},
                      {"summary", table(made, jalon_adjustment_summary).object(0)},
                      {"iterations", table(made, jalon_adjustment_iterations).list()}};
    write_text_file(folder.path("adjustment.json"),
                    result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    const Json notes{
        {"title", "Drive and buildings adjusted together"},
        {"input", {{"model", model}, {"cloud", cloud.path}, {"trajectory", trajectory}}},
        {"times", times}};
    must(jalon_report_write_adjustment(
        made.get(), inputs.truth.get(),
        notes.dump(-1, ' ', false, Json::error_handler_t::replace).c_str(),
        folder.path("report.html").c_str(), viewer.params("adjustment_report").get(),
        console.task()));
    folder.commit();
    say(console, made);
    console.say("wrote " + output +
                ": report.html, trajectory.txt, cloud.las, cloud.ply, model.obj, model.city.json, "
                "adjustment.json, controls.csv, blocks.csv, facades.csv, strips.csv, matches.csv");
    console.result(result);
  }
};

}  // namespace

void add_adjust(Command& app) {
  Command command = app.subcommand(
      "adjust", "Brings a mobile scan and a building model into agreement, each by its sigmas");
  auto state = std::make_shared<Adjust>();
  command
      .option("model", state->model,
              "Buildings: CityJSON or OBJ; an adjusted model.city.json keeps its strips")
      .required()
      .type_name("MODEL");
  command.option("cloud", state->cloud.path, "The scan, with the field time (s)")
      .required()
      .type_name("CLOUD");
  command
      .option("trajectory", state->trajectory,
              "Of the vehicle, with sigmas of position: text with named columns, or SBET")
      .required()
      .type_name("TRAJECTORY");
  add_output_folder(command, state->output);
  command.option("--sigmas", state->sigmas, "The file smrmsg that goes with SBET")
      .type_name("FILE");
  command
      .option(
          "--truth", state->truth,
          "The drive as it was, e.g. of a virtual scan: text with named columns; for the report")
      .type_name("FILE");
  state->cloud.add_points_to(command);
  state->settings.add_to(command);
  state->strip_settings.add_to(command, "strips-");
  state->trajectory_settings.add_to(command, "trajectory-");
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set (adjust):\n" + describe(make_params("adjust").get()) +
           "\nParameters of --strips-set (building_strips):\n" +
           describe(make_params("building_strips").get()) +
           "\nParameters of --trajectory-set (trajectory_file):\n" +
           describe(make_params("trajectory_file").get()) +
           "\nExamples:\n  jalon scan --method mobile -o drive.ply --model street.obj "
           "--trajectory drive.txt\n"
           "  jalon adjust street.obj drive.ply drive.txt -o adjusted --strips-set touch_m=2\n"
           "  jalon adjust city.json drive.las sbet.out -o adjusted --sigmas smrmsg.out "
           "--trajectory-set projection=lambert93";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
