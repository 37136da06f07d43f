// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/cloud_job.h"
#include "cli/output_check.h"

namespace jalon::cli {

namespace {

struct Clean {
  CloudJob job;
  double duplicate_tolerance_m = 1e-4;  // Boulaassal 2010, 3.3: equal to the tenth of a millimetre
  bool keep_duplicates = false;
  bool remove_outliers = false;
  double voxel_m = 0;
  bool facade_only = false;

  void report(const Console& console, nlohmann::ordered_json& steps, const char* name,
              const jalon_reduction& r) const {
    console.say(std::string(name) + ": " + grouped(r.count_in) + " -> " + grouped(r.count_out) +
                " points, " + grouped(r.removed) + " removed (" + fixed(r.removed_percent, 2) +
                " %)");
    steps.push_back({{"step", name},
                     {"count_in", r.count_in},
                     {"count_out", r.count_out},
                     {"removed", r.removed},
                     {"removed_percent", r.removed_percent}});
  }

  void run() const {
    Console console(job.common);
    const Params outliers = make_params("outliers"), voxels = make_params("subsample");
    if (!remove_outliers && job.settings.is_given())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--set and --params are for --outliers"};
    job.settings.apply(outliers.get());
    must(jalon_params_set_string(voxels.get(), "method", "voxel"));
    if (voxel_m > 0) must(jalon_params_set_double(voxels.get(), "cell_m", voxel_m));
    check_output_file(job.output, "cloud");
    Cloud cloud = job.read(console);
    auto steps = nlohmann::ordered_json::array();
    jalon_reduction reduction;
    if (!keep_duplicates) {
      console.step("duplicates");
      must(jalon_cloud_remove_duplicates(cloud.get(), duplicate_tolerance_m, console.task(),
                                         Out(cloud), &reduction));
      report(console, steps, "duplicates", reduction);
    }
    if (facade_only) {
      console.step("facade");
      const uint64_t before = count_of(cloud);
      must(jalon_cloud_split_interest(cloud.get(), nullptr, console.task(), Out(cloud), nullptr));
      const uint64_t after = count_of(cloud);
      report(console, steps, "unwanted points",
             {before, after, before - after,
              before > 0 ? 100.0 * static_cast<double>(before - after) / static_cast<double>(before)
                         : 0});
    }
    if (remove_outliers) {
      console.step("outliers");
      must(jalon_cloud_remove_outliers(cloud.get(), outliers.get(), console.task(), Out(cloud),
                                       &reduction));
      report(console, steps, "outliers", reduction);
    }
    if (voxel_m > 0) {
      console.step("sampling");
      must(
          jalon_cloud_subsample(cloud.get(), voxels.get(), console.task(), Out(cloud), &reduction));
      report(console, steps, "voxels", reduction);
    }
    if (count_of(cloud) == 0)
      throw Failure{JALON_ERROR_DEGENERATE, job.input.path + ": no point is left, nothing written"};
    job.write(console, cloud, nullptr);
    console.say("wrote " + job.output);
    nlohmann::ordered_json result = job.result(cloud);
    result["steps"] = steps;
    console.result(result);
  }
};

}  // namespace

void add_clean(Command& app) {
  Command command =
      app.subcommand("clean", "Removes duplicates, outliers and unwanted points; thins");
  auto state = std::make_shared<Clean>();
  state->job.add_to(command, "-o,--output", "Parameters of --set (for --outliers)", "outliers",
                    "Example: jalon clean scan.las -o clean.las --outliers --voxel 0.02");
  command
      .option("--duplicate-tolerance", state->duplicate_tolerance_m,
              "Points that agree after rounding to this length are one (m)")
      .positive()
      .shows_default();
  command.flag("--keep-duplicates", state->keep_duplicates, "Do not look for duplicates");
  command.flag("--facade", state->facade_only,
               "Keep the largest vertical entity: drops obstacles in front and ghosts behind");
  command.flag("--outliers", state->remove_outliers, "Remove isolated points");
  command.option("--voxel", state->voxel_m, "Thin to one point a cell of this edge length (m)")
      .positive();
  command.on_run([state] { state->run(); });
}

}  // namespace jalon::cli
