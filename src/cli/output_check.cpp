// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/output_check.h"

#include <cstring>
#include <filesystem>

#include "cli/handles.h"

namespace jalon::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_output(const std::string& path, const std::string& why) {
  throw Failure{JALON_ERROR_IO, path + ": " + why};
}

// "a/b/c" or ".city.json" in small letters.
std::string small(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

std::string written_extensions(const char* content) {
  uint64_t count = 0;
  must(jalon_format_count(&count));
  std::string out;
  for (uint64_t i = 0; i < count; ++i) {
    const char *extensions = nullptr, *abilities = nullptr;
    must(jalon_format_info(i, nullptr, &extensions, &abilities));
    const char* part = std::strstr(abilities, content);
    // "cloud read write, model write": up to the next comma it is of this content.
    const char* comma = part == nullptr ? nullptr : std::strchr(part, ',');
    const char* write = part == nullptr ? nullptr : std::strstr(part, "write");
    if (write == nullptr || (comma != nullptr && write > comma)) continue;
    out += " ";
    for (const char* c = extensions; *c != '\0'; ++c) out += *c == ' ' ? "  " : std::string(1, *c);
    out += " ";
  }
  return out;
}

void check_output_folder(const std::string& path) {
  std::error_code ignored;
  for (fs::path at = path; !at.empty(); at = at.parent_path()) {
    if (fs::is_directory(at, ignored) || at == at.parent_path()) return;
    if (fs::exists(at, ignored))
      refuse_output(path, at == path ? "it is a file; the results need a folder"
                                     : at.string() + " is a file, no folder");
  }
}

void check_output_file(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuse_output(path, "it is a folder; a file is needed");
  fs::path folder = fs::path(path).parent_path();
  // The index of a data set of several files, whose folder its writer makes.
  if (small(fs::path(path).filename().string()) == "ept.json") folder = folder.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    refuse_output(path, "there is no folder " + folder.string());
}

void check_output_file(const std::string& path, const char* content) {
  check_output_file(path);
  const std::string name = small(fs::path(path).filename().string());
  const std::string known = written_extensions(content);
  if (name.find('.') != std::string::npos && known.find(" " + name + " ") != std::string::npos)
    return;
  for (size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1))
    if (known.find(" " + name.substr(dot + 1) + " ") != std::string::npos) return;
  std::string list;
  for (size_t at = known.find_first_not_of(' '); at != std::string::npos;) {
    const size_t end = known.find(' ', at);
    list += (list.empty() ? "" : ", ") + known.substr(at, end - at);
    at = known.find_first_not_of(' ', end);
  }
  throw Failure{
      JALON_ERROR_UNSUPPORTED,
      path + ": no " + content + " can be written with this extension; there are: " + list};
}

}  // namespace jalon::cli
