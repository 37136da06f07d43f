// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/cloud_job.h"

namespace jalon::cli {

namespace {

void run_of_convert(const CloudJob& job) {
  Console console(job.common);
  const Params options = make_params("write");
  job.settings.apply(options.get());
  const Cloud cloud = job.read(console);
  job.write(console, cloud, options.get());
  console.say(grouped(count_of(cloud)) + " points: " + job.input.path + " -> " + job.output);
  console.result(job.result(cloud));
}

}  // namespace

void add_convert(Command& app) {
  Command command =
      app.subcommand("convert", "Reads a scan and writes it in the format of the new extension");
  auto job = std::make_shared<CloudJob>();
  job->add_to(command, "output", "Parameters of --set", "write",
              "Examples:\n  jalon convert scan.las scan.ply\n"
              "  jalon convert scan.txt scan.las --columns \"x y z intensity\"");
  command.on_run([job] { run_of_convert(*job); });
}

}  // namespace jalon::cli
