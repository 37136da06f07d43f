// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/cloud_job.h"
#include "cli/output_check.h"

namespace jalon::cli {

namespace {

void run_of_normals(const CloudJob& job) {
  Console console(job.common);
  const Params options = make_params("normals");
  job.settings.apply(options.get());
  check_output_file(job.output, "cloud");
  const Cloud cloud = job.read(console);
  console.step("normals");
  must(jalon_cloud_compute_normals(cloud.get(), options.get(), console.task()));
  const double seconds = console.seconds();
  job.write(console, cloud, nullptr);
  console.say(grouped(count_of(cloud)) + " normals in " + fixed(seconds, 2) + " s -> " +
              job.output);
  nlohmann::ordered_json result = job.result(cloud);
  result["seconds"] = seconds;
  console.result(result);
}

}  // namespace

void add_normals(Command& app) {
  Command command = app.subcommand("normals", "Computes a normal for every point");
  auto job = std::make_shared<CloudJob>();
  job->add_to(
      command, "-o,--output", "Parameters of --set", "normals",
      "Example: jalon normals scan.las -o normals.ply --set k=24 --set orientation=centroid");
  command.on_run([job] { run_of_normals(*job); });
}

}  // namespace jalon::cli
