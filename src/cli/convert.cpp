// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/output_check.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Convert {
  Common common;
  Input input;  ///< how each of the inputs is read
  Settings settings;
  std::vector<std::string> files;  ///< the last one is written

  std::vector<std::string> inputs() const { return {files.begin(), files.end() - 1}; }
  const std::string& output() const { return files.back(); }
};

/// What files of this name hold by the table of formats: "cloud", "model", or both for PLY; reading
/// or writing. The longest extension that is known tells; the name "ept.json" is one as a whole.
/// Names of no format that is known hold clouds, which text has any name for.
struct Holds {
  bool cloud = false, model = false;
};

Holds holds_of_extension(const std::string& extension, const char* ability, bool& is_known) {
  Holds holds;
  uint64_t count = 0;
  must(jalon_format_count(&count));
  for (uint64_t i = 0; i < count; ++i) {
    const char *extensions = nullptr, *abilities = nullptr;
    must(jalon_format_info(i, nullptr, &extensions, &abilities));
    const std::string all = std::string(" ") + extensions + " ", able = abilities;
    if (all.find(" " + extension + " ") == std::string::npos) continue;
    is_known = true;
    const size_t comma = std::min(able.find(','), able.size());
    for (const std::string& part : {able.substr(0, comma), able.substr(comma)}) {
      const bool can = part.find(ability) != std::string::npos;
      holds.cloud = holds.cloud || (can && part.find("cloud") != std::string::npos);
      holds.model = holds.model || (can && part.find("model") != std::string::npos);
    }
  }
  return holds;
}

Holds holds_of(const std::string& path, const char* ability) {
  std::string name = std::filesystem::path(path).filename().string();
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const size_t first = name.find('.');
  bool is_known = false;
  Holds holds;
  if (first != std::string::npos) holds = holds_of_extension(name, ability, is_known);
  for (size_t dot = first; dot != std::string::npos && !is_known; dot = name.find('.', dot + 1))
    holds = holds_of_extension(name.substr(dot + 1), ability, is_known);
  return holds;
}

// By what the output can hold; where that is either, by what the first input can.
bool is_of_models(const Convert& job) {
  const Holds to = holds_of(job.output(), "write");
  if (to.cloud != to.model) return to.model;
  const Holds from = holds_of(job.files.front(), "read");
  return to.model && from.model && !from.cloud;
}

void convert_model(const Convert& job, Console& console) {
  if (job.files.size() > 2)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                  job.output() + ": several models do not become one; give one input"};
  const Params options = make_params("write");
  job.settings.apply(options.get());
  console.step("reading");
  Model model;
  must_read(jalon_model_read(job.files.front().c_str(), nullptr, console.task(), Out(model)));
  console.step("writing");
  must(jalon_model_write(model.get(), job.output().c_str(), options.get(), console.task()));
  uint64_t parts = 0;
  must(jalon_model_part_count(model.get(), &parts));
  console.say("model of " + grouped(parts) + " parts: " + job.files.front() + " -> " +
              job.output());
  console.result({{"input", job.files.front()}, {"output", job.output()}, {"parts", parts}});
}

// Neighbours first, so that no point is copied more often than the number of inputs has bits.
Cloud one_of_all(std::vector<Cloud> clouds, Console& console) {
  while (clouds.size() > 1) {
    std::vector<Cloud> pairs;
    for (size_t i = 0; i + 1 < clouds.size(); i += 2) {
      Cloud both;
      must(jalon_cloud_append(clouds[i].get(), clouds[i + 1].get(), console.task(), Out(both)));
      clouds[i].reset();
      clouds[i + 1].reset();
      pairs.push_back(std::move(both));
    }
    if (clouds.size() % 2 == 1) pairs.push_back(std::move(clouds.back()));
    clouds = std::move(pairs);
  }
  return std::move(clouds.front());
}

// What "--set" says of writing, as far as it concerns clouds.
void set_writing(jalon_params* convert, jalon_params* write) {
  const char* text = nullptr;
  must(jalon_params_to_json(convert, &text));
  const Json known = Json::parse(text);
  must(jalon_params_to_json(write, &text));
  Json wanted = Json::object();
  const Json given = Json::parse(text);
  for (const auto& [name, value] : given.items())
    if (known.contains(name)) wanted[name] = value;
  must(jalon_params_from_json(convert, wanted.dump().c_str()));
}

// As much in memory as a piece takes, where the formats allow it.
uint64_t convert_file(const Convert& job, jalon_params* write, Console& console) {
  console.step("converting");
  const Params options = job.input.reading("convert");
  set_writing(options.get(), write);
  uint64_t count = 0;
  const std::string& from = job.files.front();
  const jalon_status status = jalon_cloud_convert(from.c_str(), job.output().c_str(), options.get(),
                                                  console.task(), &count);
  const bool is_of_input = std::string_view(jalon_last_error_message()).starts_with(from);
  if (is_of_input) must_read(status);
  must(status);
  return count;
}

uint64_t convert_files(const Convert& job, const jalon_params* write, Console& console) {
  std::vector<Cloud> clouds;
  for (const std::string& path : job.inputs()) {
    console.step("reading");
    Input one = job.input;
    one.path = path;
    clouds.push_back(one.read(console));
  }
  const Cloud cloud = one_of_all(std::move(clouds), console);
  console.step("writing");
  must(jalon_cloud_write(cloud.get(), job.output().c_str(), write, console.task()));
  return count_of(cloud);
}

void convert_clouds(const Convert& job, Console& console) {
  const Params options = make_params("write");
  job.settings.apply(options.get());
  const std::vector<std::string> inputs = job.inputs();
  const bool is_one = inputs.size() == 1;
  const uint64_t count = is_one && job.input.station.empty()
                             ? convert_file(job, options.get(), console)
                             : convert_files(job, options.get(), console);
  console.say(grouped(count) +
              " points: " + (is_one ? inputs.front() : std::to_string(inputs.size()) + " files") +
              " -> " + job.output());
  Json result;
  if (is_one) result["input"] = inputs.front();
  else result["inputs"] = inputs;
  result["output"] = job.output();
  result["points"] = count;
  console.result(result);
}

void run_of_convert(const Convert& job) {
  check_output_file(job.output());
  Console console(job.common);
  if (is_of_models(job)) convert_model(job, console);
  else convert_clouds(job, console);
}

}  // namespace

void add_convert(Command& app) {
  Command command = app.subcommand(
      "convert", "Reads scans or a model and writes them in the format of the last name");
  auto job = std::make_shared<Convert>();
  constexpr int kMostFiles = 100000;
  command
      .option("files", job->files,
              "Files to read, then the one to write: scans become one with all their stations; "
              "\"jalon formats\" lists what is read and written")
      .required()
      .expected(2, kMostFiles)
      .type_name("INPUT... OUTPUT");
  job->input.add_reading_to(command);
  job->settings.add_to(command);
  add_common(command, job->common);
  command.footer([=] {
    return "Parameters of --set:\n" + describe(make_params("write").get()) +
           "\nExamples:\n  jalon convert scan.las scan.ply\n"
           "  jalon convert hall.ptx yard.e57 both.las\n  jalon convert model.city.json model.dxf\n"
           "  jalon convert scan.txt scan.las --columns \"x y z intensity\"";
  });
  command.on_run([job] { run_of_convert(*job); });
}

}  // namespace jalon::cli
