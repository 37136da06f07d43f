// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/options.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

// "cloud read write, model write" cut at the commas: what follows this content, or "".
std::string abilities_with(const std::string& abilities, const std::string& content) {
  for (size_t at = 0; at < abilities.size();) {
    const size_t end = std::min(abilities.find(", ", at), abilities.size());
    const std::string part = abilities.substr(at, end - at);
    if (part.starts_with(content + " ")) return part.substr(content.size() + 1);
    at = end + 2;
  }
  return "";
}

std::string padded(std::string text, size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

// ".city.json .json" of "city.json json".
std::string dotted(const std::string& extensions) {
  std::string out = ".";
  for (const char c : extensions) out += c == ' ' ? std::string(" .") : std::string(1, c);
  return out;
}

std::string row(const std::string& name, const std::string& extensions, const std::string& clouds,
                const std::string& models) {
  constexpr size_t kName = 10, kExtensions = 28, kClouds = 13;
  std::string line =
      padded(name, kName) + padded(extensions, kExtensions) + padded(clouds, kClouds) + models;
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

Json words_of(const std::string& text) {
  Json out = Json::array();
  for (const char* word : {"read", "write"})
    if (text.find(word) != std::string::npos) out.push_back(word);
  return out;
}

void run_formats(const Common& common) {
  Console console(common);
  uint64_t count = 0;
  must(jalon_format_count(&count));
  console.say(row("format", "extensions", "clouds", "models"));
  Json list = Json::array();
  for (uint64_t i = 0; i < count; ++i) {
    const char *name = nullptr, *extensions = nullptr, *abilities = nullptr;
    must(jalon_format_info(i, &name, &extensions, &abilities));
    const std::string clouds = abilities_with(abilities, "cloud"),
                      models = abilities_with(abilities, "model"),
                      drawings = abilities_with(abilities, "drawing");
    std::string line =
        row(name, dotted(extensions), clouds.empty() ? "-" : clouds, models.empty() ? "-" : models);
    if (!drawings.empty()) line += "  (drawings: " + drawings + ")";
    console.say(line);
    list.push_back({{"name", name},
                    {"extensions", extensions},
                    {"clouds", words_of(clouds)},
                    {"models", words_of(models)},
                    {"drawings", words_of(drawings)}});
  }
  console.result({{"formats", list}});
}

}  // namespace

void add_formats(Command& app) {
  Command command = app.subcommand(
      "formats", "The formats of files: extensions, and what is read and written of each");
  auto common = std::make_shared<Common>();
  add_common(command, *common);
  command.footer("Example: jalon formats --json");
  command.on_run([=] { run_formats(*common); });
}

}  // namespace jalon::cli
