// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/outputs/evaluate_tables.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

/// One of the two results: a file, and the fields that hold segments and classes.
struct Side {
  Input input;
  std::string labels, class_field;
  std::vector<double> noise;

  Segmentation segmentation(const Console& console, const Cloud& cloud) const {
    const Params options = make_params("labels");
    if (!noise.empty())
      must(jalon_params_set_doubles(options.get(), "noise_labels", noise.data(), noise.size()));
    Segmentation made;
    must(jalon_segmentation_from_labels(cloud.get(), labels.c_str(), options.get(), console.task(),
                                        Out(made)));
    return made;
  }
};

struct Evaluate {
  Common common;
  Side automatic, reference;
  Settings settings;
  std::vector<double> ignored_classes;
  std::string csv;
  bool only_classes = false;

  bool one_file() const { return reference.input.path.empty(); }
  bool has_classes() const {
    return !reference.class_field.empty() || !automatic.class_field.empty();
  }

  void check() const {
    const auto refuse = [](const char* text) { throw Failure{JALON_ERROR_INVALID_ARGUMENT, text}; };
    if (only_classes && !has_classes())
      refuse("--classes-only needs --class-field and --reference-class-field");
    if (automatic.class_field.empty() != reference.class_field.empty())
      refuse("--class-field and --reference-class-field are given together");
    if (one_file() && !only_classes && reference.labels.empty())
      refuse("with one file --reference-labels names the field of the reference");
    if (!ignored_classes.empty() && !has_classes())
      refuse("--ignore-class needs --class-field and --reference-class-field");
    if (only_classes && !csv.empty()) refuse("--csv is the table of segments: no --classes-only");
    if (!csv.empty()) check_output_file(csv);
  }

  Json segments(const Console& console, const Cloud& found, const Cloud& truth) const {
    const Params options = make_params("evaluation");
    settings.apply(options.get());
    const Segmentation a = automatic.segmentation(console, found);
    Side side = reference;
    if (side.labels.empty()) side.labels = automatic.labels;
    const Segmentation r = side.segmentation(console, truth);
    Evaluation evaluation;
    must(jalon_segmentation_evaluate(a.get(), r.get(), options.get(), console.task(),
                                     Out(evaluation)));
    const EvaluationTables tables(evaluation.get());
    if (tables.reference.rows() == 0)
      throw Failure{JALON_ERROR_INSUFFICIENT_DATA, (one_file() ? automatic : reference).input.path +
                                                       ": no point has a segment in "
                                                       "field \"" +
                                                       side.labels +
                                                       "\": there is nothing to compare with"};
    const Lengths lengths =
        Lengths::of(automatic.input, found).with(Lengths::of(automatic.input, truth));
    tables.print(console, lengths);
    if (!lengths.is_known()) console.say(lengths.note());
    if (!csv.empty()) write_text_file(csv, tables.pairs.csv());
    return tables.json();
  }

  // The reference's classes come onto the automatic cloud: same points, same order.
  Json classes(const Console& console, const Cloud& found, const Cloud& truth) const {
    const char* name = "jalon:reference class";
    Fields fields;
    must(jalon_cloud_fields(truth.get(), Out(fields)));
    jalon_array_view view;
    must(jalon_fields_view(fields.get(), reference.class_field.c_str(), &view));
    must(jalon_cloud_set_field(found.get(), name, view.data, view.type, view.components, view.count,
                               view.stride_bytes, nullptr, nullptr));
    const Params options = make_params("confusion");
    if (!ignored_classes.empty())
      must(jalon_params_set_doubles(options.get(), "ignored_classes", ignored_classes.data(),
                                    ignored_classes.size()));
    Fields rows, totals;
    must(jalon_cloud_confusion(found.get(), automatic.class_field.c_str(), name, options.get(),
                               console.task(), Out(rows), Out(totals)));
    const ConfusionTables tables{Table(std::move(rows)), Table(std::move(totals))};
    tables.print(console);
    return tables.json();
  }

  void run() {
    check();
    Console console(common);
    console.step("reading");
    const Cloud found = automatic.input.read(console);
    Cloud other;
    if (!one_file()) {
      // The points of both must be the same, and so is what is read of them.
      reference.input.unit = automatic.input.unit;
      reference.input.box = automatic.input.box;
      reference.input.spacing_m = automatic.input.spacing_m;
      reference.input.drop_invalid = automatic.input.drop_invalid;
      if (reference.input.columns.empty()) reference.input.columns = automatic.input.columns;
      other = reference.input.read(console);
      require_same_count(found, other);
    }
    const Cloud& truth = one_file() ? found : other;
    console.step("comparing");
    Json result{{"automatic", automatic.input.path},
                {"reference", one_file() ? automatic.input.path : reference.input.path},
                {"points", count_of(found)}};
    if (!only_classes) result["segments"] = segments(console, found, truth);
    if (has_classes()) result["classes"] = classes(console, found, truth);
    console.result(result);
  }

  void require_same_count(const Cloud& a, const Cloud& b) const {
    if (count_of(a) == count_of(b)) return;
    throw Failure{JALON_ERROR_FORMAT, automatic.input.path + " has " + grouped(count_of(a)) +
                                          " points, " + reference.input.path + " " +
                                          grouped(count_of(b)) +
                                          ": both must hold the same points in the same order"};
  }
};

void add_options(Command& command, Evaluate& state) {
  Side &a = state.automatic, &r = state.reference;
  command.option("automatic", a.input.path, "Labelled scan to judge").required().type_name("AUTO");
  command
      .option("reference", r.input.path,
              "Labelled scan that is right, the same points; none: fields of AUTO")
      .type_name("REFERENCE");
  command.option("--labels", a.labels, "Field of AUTO with a whole number a segment")
      .default_text("label")
      .type_name("FIELD");
  command
      .option("--reference-labels", r.labels,
              "Field of the reference; with two files the same name by default")
      .type_name("FIELD");
  command
      .option("--noise-label", a.noise,
              "Value of AUTO's field that means no segment; 0 by default (repeatable)")
      .one_each_time();
  command.option("--reference-noise-label", r.noise, "The same of the reference (repeatable)")
      .one_each_time();
  command
      .option("--class-field", a.class_field,
              "Field of AUTO with a class a point: also a confusion matrix")
      .type_name("FIELD");
  command
      .option("--reference-class-field", r.class_field,
              "Field of the reference with the true class")
      .type_name("FIELD");
  command
      .option("--ignore-class", state.ignored_classes,
              "Leave points of this reference class out (repeatable)")
      .one_each_time();
  command.flag("--classes-only", state.only_classes, "No segments, only classes");
  a.input.add_points_to(command);
  command.option("--reference-columns", r.input.columns, "Columns of REFERENCE; AUTO's by default")
      .type_name("NAMES");
  command.option("--csv", state.csv, "Also write the table of pairs as CSV").type_name("FILE");
}

}  // namespace

void add_evaluate(Command& app) {
  Command command =
      app.subcommand("evaluate-segmentation",
                     "Compares segments, and classes, with a reference of the same points");
  auto state = std::make_shared<Evaluate>();
  add_options(command, *state);
  state->settings.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("evaluation").get()) + R"(
TDR = I / Card SR (detected share of a reference segment), TDA = I / Card A (right share of an automatic one),
D+ and D- the points of one side alone. Segments are paired one to one with the largest total overlap.
Exit codes: 0 compared, however well or badly they agree; 2 wrong options, unsuitable fields or other points;
3 a file or field is missing or malformed, or the files have unequal numbers of points; others as in jalon --help.

Examples:
  jalon evaluate-segmentation result/segments.las reference.las --set min_points=50
  jalon evaluate-segmentation scan.las --labels label --reference-labels face --reference-noise-label 4294967295
  jalon evaluate-segmentation scan.las --classes-only --class-field found --reference-class-field class --json)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
