// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/options.h"

namespace jalon::cli {

namespace {

struct Convert {
  Common common;
  Input input;
  Settings settings;
  std::string output;

  void run() const {
    Console console(common);
    console.step("reading");
    const Cloud cloud = input.read(console);
    console.step("writing");
    const Params options = make_params("write");
    settings.apply(options.get());
    must(jalon_cloud_write(cloud.get(), output.c_str(), options.get(), console.task()));
    console.say(grouped(count_of(cloud)) + " points: " + input.path + " -> " + output);
    console.result({{"input", input.path}, {"output", output}, {"points", count_of(cloud)}});
  }
};

}  // namespace

void add_convert(CLI::App& app) {
  auto* command = app.add_subcommand("convert", "Reads a scan and writes it in the format of the new extension");
  auto state = std::make_shared<Convert>();
  state->input.add_to(*command);
  command->add_option("output", state->output, "File to write: .las, .ply, .xyz, .txt, .csv")
      ->required()
      ->type_name("OUTPUT");
  state->settings.add_to(*command);
  add_common(*command, state->common);
  command->footer([] {
    return "Parameters of --set:\n" + describe(make_params("write").get()) +
           "\nExamples:\n  jalon convert scan.las scan.ply\n"
           "  jalon convert scan.txt scan.las --columns \"x y z intensity\"";
  });
  command->callback([state] { state->run(); });
}

}  // namespace jalon::cli
