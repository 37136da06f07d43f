// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/options.h"
#include "cli/output_check.h"
#include "cli/output_folder.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kEvaluateModelDegrees = 57.29577951308232;

std::string right_of_evaluate_model(const std::string& text, size_t width) {
  return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

std::string cell(const Table& table, const std::string& name, uint64_t row, size_t width,
                 int decimals, double scale = 1) {
  return right_of_evaluate_model(fixed(scale * table.number(name.c_str(), row), decimals), width);
}

Table table_of(const jalon_model_evaluation* evaluation,
               jalon_status (*get)(const jalon_model_evaluation*, jalon_fields**)) {
  Fields fields;
  must(get(evaluation, Out(fields)));
  return Table(std::move(fields));
}

constexpr const char* kIndices[] = {"completeness", "correctness", "quality",
                                    "branching",    "miss",        "failure"};

/// A model's evaluation for people and scripts.
struct ModelTables {
  ModelTables(const jalon_model_evaluation* e, Lengths shown)
      : lengths(std::move(shown)),
        pairs(table_of(e, jalon_model_evaluation_pairs)),
        automatic(table_of(e, jalon_model_evaluation_automatic)),
        reference(table_of(e, jalon_model_evaluation_reference)),
        vertices(table_of(e, jalon_model_evaluation_vertices)),
        totals(table_of(e, jalon_model_evaluation_totals)) {}

  void print(const Console& console) const {
    print_faces(console);
    print_vertices(console);
  }

  Json json() const {
    return {{"totals", totals.object(0)},
            {"pairs", pairs.list()},
            {"automatic", automatic.list()},
            {"reference", reference.list()},
            {"vertices", vertices.list()}};
  }

  Lengths lengths;
  Table pairs, automatic, reference, vertices, totals;

 private:
  std::string small(const Table& table, const std::string& name, uint64_t row, size_t width) const {
    return right_of_evaluate_model(lengths.fine(table.number(name.c_str(), row), 1), width);
  }
  void print_faces(const Console& console) const {
    console.say(" reference  automatic" + lengths.heading("A", "m2", 11) +
                lengths.heading("R", "m2", 11) + lengths.heading("A n R", "m2", 11) +
                "  compl  corr   qual   branch   miss  FP/R  angle deg" +
                lengths.heading("dist", "mm", 9) + lengths.heading("H95", "mm", 8));
    const auto face = [](const Table& side, uint64_t row) {
      return right_of_evaluate_model(grouped(side.count("face", row)), 10);
    };
    for (uint64_t i = 0; i < pairs.rows(); ++i) {
      std::string line = face(reference, pairs.count("reference", i)) + " ";
      line += face(automatic, pairs.count("automatic", i));
      for (const char* name : {"area_automatic", "area_reference", "intersection"})
        line += cell(pairs, name, i, 11, 3);
      for (const char* name : kIndices) line += cell(pairs, name, i, 7, 3);
      console.say(line + cell(pairs, "angle", i, 10, 3, kEvaluateModelDegrees) +
                  small(pairs, "distance", i, 9) + small(pairs, "hausdorff95", i, 8));
    }
    std::string sums = right_of_evaluate_model("total", 21);
    for (const char* name : {"area_automatic", "area_reference", "intersection"})
      sums += cell(totals, name, 0, 11, 3);
    for (const char* name : kIndices) sums += cell(totals, std::string("total_") + name, 0, 7, 3);
    console.say(sums);
    for (const char* kind : {"mean", "std"}) {
      std::string line = right_of_evaluate_model(kind, 54);
      for (const char* name : kIndices)
        line += cell(totals, std::string(kind) + "_" + name, 0, 7, 3);
      line += cell(totals, std::string(kind) + "_angle", 0, 10, 3, kEvaluateModelDegrees);
      console.say(line + small(totals, std::string(kind) + "_plane_distance", 0, 9));
    }
    const auto count = [&](const char* name) { return grouped(totals.count(name, 0)); };
    console.say("pairs " + count("pairs") + ", of one class " + count("same_class") +
                "; unmatched: " + count("unmatched_reference") + " reference, " +
                count("unmatched_automatic") +
                " automatic (they count in the totals); left out as too small: " +
                count("left_out_reference") + " reference, " + count("left_out_automatic") +
                " automatic");
    const auto rate = [&](const char* name) { return fixed(totals.number(name, 0), 4); };
    console.say("contours: precision " + rate("mean_contour_precision") + ", recall " +
                rate("mean_contour_recall") + ", F1 " + rate("mean_contour_f1"));
  }

  void print_vertices(const Console& console) const {
    console.say("vertices " + grouped(totals.count("vertices", 0)) +
                (lengths.is_known() ? " (mm)" : "     ") +
                "         DX        DY        DZ         D     along        up       out");
    for (const char* kind : {"mean", "std", "rms"}) {
      std::string line = right_of_evaluate_model(kind, 16);
      for (const char* name : {"dx", "dy", "dz", "distance", "along", "up", "out"})
        line += small(totals, std::string(kind) + "_" + name, 0, 10);
      console.say(line);
    }
    console.say("largest D " + lengths.fine(totals.number("max_distance", 0), 1) + " " +
                lengths.fine());
    if (!lengths.is_known()) console.say(lengths.note());
  }
};

struct EvaluateModel {
  Common common;
  std::string automatic, reference, output;
  Settings settings;

  static Model read(const Console& console, const std::string& path) {
    Model model;
    must_read(jalon_model_read(path.c_str(), nullptr, console.task(), Out(model)));
    return model;
  }

  void run() const {
    const Params options = make_params("model_evaluation");
    settings.apply(options.get());
    if (!output.empty()) check_output_folder(output);
    Console console(common);
    console.step("reading");
    const Model a = read(console, automatic), r = read(console, reference);
    warn_of_sizes(console, reference, box_of(r), automatic, box_of(a));
    console.step("comparing");
    ModelEvaluation evaluation;
    must(jalon_model_evaluate(a.get(), r.get(), options.get(), console.task(), Out(evaluation)));
    const ModelTables tables(evaluation.get(),
                             Lengths::of(automatic, a).with(Lengths::of(reference, r)));
    Json result{{"automatic", automatic}, {"reference", reference}};
    const char* parameters = nullptr;
    must(jalon_params_to_json(options.get(), &parameters));
    result["parameters"] = Json::parse(parameters);
    result.update(tables.json());
    if (!output.empty()) {
      OutputFolder folder(output);
      write_text_file(folder.path("faces.csv"), tables.pairs.csv());
      write_text_file(folder.path("vertices.csv"), tables.vertices.csv());
      const std::string text = result.dump(1, ' ', false, Json::error_handler_t::replace);
      write_text_file(folder.path("evaluation.json"), text + "\n");
      folder.commit();
    }
    tables.print(console);
    if (!output.empty())
      console.say("wrote " + output + ": faces.csv, vertices.csv, evaluation.json");
    console.result(result);
  }
};

}  // namespace

void add_evaluate_model(Command& app) {
  Command command = app.subcommand(
      "evaluate-model", "Compares a vector model with a reference: areas, contours, vertices");
  auto state = std::make_shared<EvaluateModel>();
  command.option("model", state->automatic, "Model to judge").required().type_name("MODEL");
  command.option("reference", state->reference, "Model that is right")
      .required()
      .type_name("REFERENCE");
  command
      .option("-o,--output", state->output,
              "Also write faces.csv, vertices.csv and evaluation.json here")
      .type_name("DIR");
  state->settings.add_to(command);
  add_common(command, state->common);
  command.footer([] {
    return "Parameters of --set:\n" + describe(make_params("model_evaluation").get()) + R"(
A and R are the areas of a face and its reference in one plane: compl(eteness) = A n R / R, corr(ectness) = A n R / A,
qual(ity) = A n R / A u R, branch(ing) = A \ R / A n R, miss = R \ A / A n R, FP/R = A \ R / R. H95: 95 % of both
borders are nearer. D: distance of homologous vertices. Faces go by their rows, counted from 0.
Exit codes: 0 compared, however well or badly they agree; 2 wrong options; 3 a file is missing or malformed; others
as in jalon --help.

Examples:
  jalon evaluate-model result/model.city.json survey.obj
  jalon evaluate-model model.obj drawn.obj --set mode=relative --set compare=openings -o result)";
  });
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
