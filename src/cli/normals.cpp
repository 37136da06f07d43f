// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/options.h"

namespace jalon::cli {

namespace {

struct Normals {
  Common common;
  Input input;
  Settings settings;
  std::string output;

  void run() const {
    Console console(common);
    console.step("reading");
    const Cloud cloud = input.read(console);
    console.step("normals");
    const Params options = make_params("normals");
    settings.apply(options.get());
    must(jalon_cloud_compute_normals(cloud.get(), options.get(), console.task()));
    const double seconds = console.seconds();
    console.step("writing");
    must(jalon_cloud_write(cloud.get(), output.c_str(), nullptr, console.task()));
    console.say(grouped(count_of(cloud)) + " normals in " + fixed(seconds, 2) + " s -> " + output);
    console.result({{"input", input.path}, {"output", output}, {"points", count_of(cloud)}, {"seconds", seconds}});
  }
};

}  // namespace

void add_normals(CLI::App& app) {
  auto* command = app.add_subcommand("normals", "Computes a normal for every point");
  auto state = std::make_shared<Normals>();
  state->input.add_to(*command);
  command->add_option("-o,--output", state->output, "File to write")->required()->type_name("FILE");
  state->settings.add_to(*command);
  add_common(*command, state->common);
  command->footer([] {
    return "Parameters of --set:\n" + describe(make_params("normals").get()) +
           "\nExample: jalon normals scan.las -o normals.ply --set k=24 --set orientation=centroid";
  });
  command->callback([state] { state->run(); });
}

}  // namespace jalon::cli
