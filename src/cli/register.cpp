// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/methods.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/inputs/pose_file.h"
#include "cli/table.h"
#include "cli/inputs/targets_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStopped[] = {"",          "converged",    "iteration limit", "too few pairs",
                                    "ambiguous", "nothing found"};

struct Register {
  ViewerOption viewer;
  Common common;
  Settings settings;
  Input reference, moving;
  std::string method, start, output;
  std::vector<std::string> targets;  ///< files of the reference's and of the moving scan's
  bool is_forced = false;            ///< writes what a pose gives that is not accepted

  Json json_of(const Registration& registration, const Json& times, jalon_params* params) const {
    jalon_transform pose;
    must(jalon_registration_pose(registration.get(), &pose));
    const char* parameters = nullptr;
    must(jalon_params_to_json(params, &parameters));
    Json matrix = Json::array();
    for (const double* row = pose.m; row != pose.m + 12; row += 4)
      matrix.push_back({row[0], row[1], row[2], row[3]});
    matrix.push_back({0, 0, 0, 1});
    Json out{{"reference", reference.path},
             {"moving", moving.path},
             {"output", output},
             {"method", method},
             {"parameters", Json::parse(parameters)},
             {"times", times},
             {"T_reference_moving", matrix}};
    out["summary"] = table(registration, jalon_registration_summary).object(0);
    out["reasons"] = reasons_of(registration);
    out["directions"] = table(registration, jalon_registration_directions).list();
    out["iterations"] = table(registration, jalon_registration_iterations).list();
    if (!targets.empty()) out["residuals"] = residuals_of(registration);
    return out;
  }

  static std::string reasons_of(const Registration& registration) {
    const char* reasons = nullptr;
    must(jalon_registration_reasons(registration.get(), &reasons));
    return reasons;
  }

  static Json residuals_of(const Registration& registration) {
    Json rows = table(registration, jalon_registration_residuals).list();
    for (size_t i = 0; i < rows.size(); ++i) {
      const char* name = nullptr;
      must(jalon_registration_pair_name(registration.get(), i, &name));
      rows[i]["name"] = name;
    }
    return rows;
  }

  Registration register_targets(const Console& console, const jalon_registrar* registrar) const {
    const Targets to = read_targets(targets[0]), from = read_targets(targets[1]);
    Registration made;
    must(jalon_registrar_run_targets(registrar, to.rows.data(), to.rows.size(), from.rows.data(),
                                     from.rows.size(), console.task(), Out(made)));
    return made;
  }

  static void say_outliers(const Console& console, const Registration& registration) {
    const Table rows = table(registration, jalon_registration_residuals);
    uint64_t outliers = 0;
    for (uint64_t i = 0; i < rows.rows(); ++i) outliers += rows.count("outlier", i);
    if (outliers > 0)
      console.say(grouped(outliers) + " of " + grouped(rows.rows()) +
                  " targets are outliers: see report.html");
  }

  template <class F>
  static Table table(const Registration& registration, F&& read) {
    Fields fields;
    must(read(registration.get(), Out(fields)));
    return Table(std::move(fields));
  }

  void say(const Console& console, const Registration& registration, const Lengths& lengths) const {
    const Table summary = table(registration, jalon_registration_summary);
    const uint64_t stopped = summary.count("stopped", 0);
    if (stopped == JALON_STOPPED_NOTHING_FOUND) {
      console.say(
          "nothing found: no pose on which the two scans agree. If they do overlap, begin near the "
          "pose with --start");
      return;
    }
    console.say(std::string(kStopped[stopped < 6 ? stopped : 0]) + " after " +
                grouped(summary.count("iterations", 0)) + " iterations on " +
                grouped(summary.count("pairs", 0)) + " pairs, rms " +
                lengths.fine(summary.number("rms", 0), 3) + " " + lengths.fine());
    if (stopped == JALON_STOPPED_AMBIGUOUS)
      console.say("a clearly different pose fits about as well; " +
                  std::string(targets.empty() ? "--start with max_turn_rad and max_shift_m chooses"
                                              : "names choose"));
    say_verdict(console, registration, summary);
    say_precision(console, summary, lengths);
  }

  static void say_verdict(const Console& console, const Registration& registration,
                          const Table& summary) {
    static constexpr const char* kVerdicts[] = {"not judged", "accepted", "doubtful", "refused"};
    const uint64_t verdict = summary.count("verdict", 0);
    std::string text = std::string("the pose is ") + kVerdicts[verdict < 4 ? verdict : 0];
    const double confidence = summary.number("confidence", 0);
    if (std::isfinite(confidence)) text += ", confidence " + fixed(confidence, 3);
    std::string reasons = reasons_of(registration);
    for (size_t at = 0; (at = reasons.find('\n', at)) != std::string::npos;)
      reasons.replace(at, 1, "; ");
    console.say(reasons.empty() ? text : text + ": " + reasons);
  }

  // A start for fine registration is not judged: found it may be used.
  static bool is_usable(const Registration& registration) {
    const Table summary = table(registration, jalon_registration_summary);
    const uint64_t verdict = summary.count("verdict", 0);
    return verdict == JALON_VERDICT_ACCEPTED ||
           (verdict == JALON_VERDICT_NONE && summary.count("converged", 0) != 0);
  }

  static void say_precision(const Console& console, const Table& summary, const Lengths& lengths) {
    if (std::isfinite(summary.number("covariance", 0, 0))) {
      const auto sigma = [&](uint32_t k) {
        return std::sqrt(summary.number("covariance", 0, 7 * k));
      };
      const auto three = [&](double unit, uint32_t first) {
        std::string text;
        for (uint32_t k = 0; k < 3; ++k) text += fixed(unit * sigma(first + k), 5) + " ";
        return text;
      };
      console.say("sigma of the centre in x y z: " + three(lengths.is_known() ? 1000 : 1, 3) +
                  lengths.fine() + "; of the turn: " + three(180 / std::numbers::pi, 0) + "deg");
    }
    if (const uint64_t open = summary.count("unobservable", 0); open > 0)
      console.say(grouped(open) + " of six directions are not fixed by the data: see report.html");
  }

  void run() const {
    Console console(common);
    if (!targets.empty() && !start.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "targets need no --start"};
    if (targets.empty() && method == "targets")
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "method targets needs --targets FILE FILE: those of REFERENCE and of MOVING"};
    check_output_folder(output);
    Registrar registrar;
    must_know(jalon_registrar_create(method.c_str(), Out(registrar)));
    Params params;
    must(jalon_registrar_params(registrar.get(), Out(params)));
    settings.apply(params.get());  // wrong parameters are told before a long read
    const bool has_start = !start.empty();
    const jalon_transform from = has_start ? read_pose(start) : jalon_transform{};
    console.step("reading");
    const Cloud to = reference.read(console), cloud = moving.read(console);
    const Lengths lengths = Lengths::of(reference, to).with(Lengths::of(moving, cloud));
    warn_of_sizes(console, reference.path, box_of(to), moving.path, box_of(cloud));
    Json times{{"read", console.seconds()}};
    console.step("registering");
    Registration made;
    if (!targets.empty()) made = register_targets(console, registrar.get());
    else
      must(jalon_registrar_run(registrar.get(), to.get(), cloud.get(), has_start ? &from : nullptr,
                               console.task(), Out(made)));
    times["register"] = console.seconds();
    console.step("writing");
    OutputFolder folder(output);
    const bool is_written = is_forced || is_usable(made);
    write_report(console, folder, made, to, cloud, times, lengths);
    if (is_written) write_registered(console, folder, made, cloud);
    const Json result = json_of(made, times, params.get());
    const std::string text = result.dump(1, ' ', false, Json::error_handler_t::replace);
    write_text_file(folder.path("registration.json"), text + "\n");
    folder.commit();
    say(console, made, lengths);
    if (!targets.empty()) say_outliers(console, made);
    console.say("wrote " + output + ": report.html, registration.json" +
                (is_written ? ", pose.txt, registered.las, registered.ply" : ""));
    if (!lengths.is_known()) console.say(lengths.note());
    console.result(result);
    if (!is_written)
      throw Failure{JALON_ERROR_DEGENERATE,
                    "the pose is not accepted, so no registered cloud is written; report.html "
                    "shows why, --force writes it"};
  }

  static void write_registered(const Console& console, OutputFolder& folder,
                               const Registration& made, const Cloud& cloud) {
    jalon_transform pose;
    must(jalon_registration_pose(made.get(), &pose));
    write_text_file(folder.path("pose.txt"), pose_text(pose));
    Cloud moved;
    must(jalon_registration_apply(made.get(), cloud.get(), console.task(), Out(moved)));
    for (const char* name : {"registered.las", "registered.ply"})
      must(jalon_cloud_write(moved.get(), folder.path(name).c_str(), nullptr, console.task()));
  }

  void write_report(const Console& console, OutputFolder& folder, const Registration& made,
                    const Cloud& to, const Cloud& cloud, const Json& times,
                    const Lengths& lengths) const {
    const Json notes{{"title", "Registration"},
                     {"input",
                      {{"reference", reference.path},
                       {"moving", moving.path},
                       {"method", method},
                       {"unit", lengths.in_report()}}},
                     {"times", times}};
    const std::string text = notes.dump(-1, ' ', false, Json::error_handler_t::replace);
    must(jalon_report_write_registration(
        made.get(), to.get(), cloud.get(), text.c_str(), folder.path("report.html").c_str(),
        viewer.params("registration_report").get(), console.task()));
  }
};

std::string tables_of_register() {
  return method_tables<Registrar>("Parameters of --set with --method ", jalon_registrar_methods,
                                  jalon_registrar_create, jalon_registrar_params);
}

}  // namespace

void add_register(Command& app) {
  Command command =
      app.subcommand("register", "Lays one scan onto another: the pose, and what it is worth");
  auto state = std::make_shared<Register>();
  command.option("reference", state->reference.path, "The scan that stays")
      .required()
      .type_name("REFERENCE");
  command.option("moving", state->moving.path, "The scan that is laid onto it")
      .required()
      .type_name("MOVING");
  add_output_folder(command, state->output);
  command
      .option("--method", state->method,
              "automatic: from anywhere, coarse, then icp (the default); icp: from a start that is "
              "about right, with --start or as they lie; coarse: from anywhere, roughly; targets: "
              "see --targets")
      .type_name("NAME");
  command
      .option("--start", state->start,
              "Pose to begin with: a file with a 4 x 4 matrix, as pose.txt")
      .type_name("FILE");
  command
      .option("--targets", state->targets,
              "Two files with the targets of REFERENCE and of MOVING, which are then registered by "
              "them; a "
              "line each: name x y z [sigma | sx sy sz] in metres, - for no name")
      .expected(2, 2)
      .type_name("FILE FILE");
  add_reading_of_two(command, state->reference, "reference-", state->moving, "moving-");
  command.flag(
      "--force", [state] { state->is_forced = true; },
      "Write pose.txt and the registered cloud also of a pose that is not accepted");
  state->settings.add_to(command);
  state->viewer.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return tables_of_register() +
           "Examples:\n  jalon register hall_1.las hall_2.las -o joined\n"
           "  jalon register hall_1.las hall_2.las -o joined --start pose.txt\n"
           "  jalon register hall_1.las hall_2.las -o joined --targets control.txt spheres_2.txt";
  });
  command.on_run([state] {
    if (!state->targets.empty()) state->method = "targets";
    if (state->method.empty()) state->method = default_method(jalon_registrar_methods);
    state->run();
  });
}

}  // namespace jalon::cli
