// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/cloud_job.h"

#include "cli/output_check.h"

#include <nlohmann/json.hpp>

namespace jalon::cli {

void CloudJob::add_to(Command& command, const char* output_option, const char* heading,
                      const char* operation, const char* examples) {
  input.add_to(command);
  command.option(output_option, output, "File to write: .las, .ply, .pcd, .xyz, .txt, .csv")
      .required()
      .type_name("OUTPUT");
  settings.add_to(command);
  add_common(command, common);
  command.footer([=] {
    return std::string(heading) + ":\n" + describe(make_params(operation).get()) + "\n" + examples;
  });
}

Cloud CloudJob::read(Console& console) const {
  check_output_file(output);
  console.step("reading");
  return input.read(console);
}

void CloudJob::write(Console& console, const Cloud& cloud, const jalon_params* options) const {
  console.step("writing");
  must(jalon_cloud_write(cloud.get(), output.c_str(), options, console.task()));
}

nlohmann::ordered_json CloudJob::result(const Cloud& cloud) const {
  return {{"input", input.path}, {"output", output}, {"points", count_of(cloud)}};
}

}  // namespace jalon::cli
