// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/formats.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "formats/files/single_precision.h"
#include "formats/files/station_file.h"
#include "formats/files/utf8.h"
#include "formats/chosen_format.h"
#include "formats/units/file_unit.h"
#include "formats/wanted_points.h"

namespace jalon {

namespace {

// "LAS, PLY or STL"
std::string listed(const std::vector<std::string>& names, const char* last) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
  return text;
}

template <class Wanted>
std::vector<std::string> names_of(Wanted&& wanted) {
  std::vector<std::string> names;
  for (const Format& format : kFormats)
    if (wanted(format)) names.emplace_back(format.name);
  return names;
}

std::string extension_of(const std::string& path) {
  const size_t dot = path.rfind('.');
  const size_t slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  return lower(std::string_view(path).substr(dot + 1));
}

// The number of letters of the longest of the format's extensions that the name has; 0 = none. One of two parts may be
// the whole name: "ept.json".
size_t extension_length(const Format& format, const std::string& name) {
  size_t longest = 0;
  std::string_view rest = format.extensions;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(' '), rest.size());
    const std::string extension(rest.substr(0, end));
    if (name.ends_with("." + extension) ||
        (name == extension && name.find('.') != std::string::npos))
      longest = std::max(longest, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return longest;
}

// nullptr for "auto".
const Format* format_of_option(std::string_view keyword) {
  for (const Format& format : kFormats)
    if (*format.keyword != '\0' && keyword == format.keyword) return &format;
  return nullptr;
}

// nullptr where no format that holds a cloud or a model has it. "a.copc.laz" is COPC, "a.laz" LAZ.
const Format* format_of_extension(const std::string& path) {
  const std::string name = lower(path.substr(path.find_last_of("/\\") + 1));
  const Format* found = nullptr;
  size_t longest = 0;
  for (const Format& format : kFormats) {
    const size_t length = extension_length(format, name);
    if ((!format.can_read() && !format.can_write()) || length <= longest) continue;
    found = &format;
    longest = length;
  }
  return found != nullptr ? found : format_of_option(extension_of(path));
}

const Format* format_recognised(const ByteSource& source, Content content) {
  for (const Format& format : kFormats)
    if (format.content == content && format.can_read() && format.recognises(source)) return &format;
  return nullptr;
}

[[noreturn]] void refuse_written_only(const ByteSource& source) {
  const auto names = names_of([](const Format& f) { return f.can_write() && !f.can_read(); });
  fail(Status::kUnsupported, "%s: %s %s written, not read", source.path().c_str(),
       listed(names, " and ").c_str(), names.size() == 1 ? "is" : "are");
}

[[noreturn]] void refuse_unknown(const ByteSource& source) {
  const auto names =
      names_of([](const Format& f) { return f.can_read() && f.content != Content::kText; });
  fail(Status::kUnsupported, "%s: neither %s nor text", source.path().c_str(),
       listed(names, ", ").c_str());
}

// A mark at the beginning outweighs the name; the name outweighs weaker signs, unless it says no
// more than that a file is text.
const Format& format_of_content(const ByteSource& source) {
  char first = 0;
  if (source.read_some(0, &first, 1) == 0) source.refuse(0, "the file is empty");
  if (const Format* found = format_recognised(source, Content::kCertain)) return *found;
  const Format* named = format_of_extension(source.path());
  if (named != nullptr && named->content == Content::kCertain)
    source.refuse(0, "a %s file starts with %s, this one does not", named->name, named->mark);
  if (named != nullptr && named->can_read() && named->content != Content::kText) return *named;
  if (const Format* found = format_recognised(source, Content::kSome)) return *found;
  if (named != nullptr && named->can_read()) return *named;
  if (named != nullptr) refuse_written_only(source);
  if (const Format* found = format_recognised(source, Content::kText)) return *found;
  refuse_unknown(source);
}

// Where the option asks for a format that lacks the function, neither content nor extension is to blame.
template <class Function>
void refuse_option(const std::string& path, const std::string& option, Function Format::*function,
                   const char* content, bool reading) {
  if (format_of_option(option) == nullptr) return;
  std::vector<std::string> able;
  for (const Format& format : kFormats)
    if (format.*function != nullptr && !(reading && format.reads_as_another))
      able.emplace_back(format.keyword);
  fail(Status::kUnsupported,
       "%s: no %s can be %s in format \"%s\", which the option \"format\" names; there are: %s",
       path.c_str(), content, reading ? "read" : "written", option.c_str(),
       listed(able, ", ").c_str());
}

bool keeps_stations_of(const Format& format, const Cloud& cloud) {
  if (format.keeps_stations || cloud.stations.empty()) return true;
  const Station& first = cloud.stations[0];
  return format.keeps_station && cloud.stations.size() == 1 && first.has_pose &&
         first.count == cloud.size();
}

// function: what a format must have to write it.
template <class Function>
[[noreturn]] void refuse_extension(const std::string& path, Function Format::*function) {
  std::string known;
  for (const Format& format : kFormats) {
    if (format.*function == nullptr) continue;
    for (const char* c = format.extensions; *c != '\0'; ++c)
      if (*c == ' ') known += ", ";
      else known += *c;
    known += ", ";
  }
  known.resize(known.size() - std::min<size_t>(known.size(), 2));
  fail(Status::kUnsupported, "%s: no format of extension \"%s\" can be written; there are: %s",
       path.c_str(), extension_of(path).c_str(), known.c_str());
}

}  // namespace

const Format& format_to_read(const ByteSource& source, const ReadSettings& settings) {
  const Format* chosen = format_of_option(settings.format);
  return chosen != nullptr ? *chosen : format_of_content(source);
}

const Format* format_to_write(const std::string& path, const WriteSettings& settings) {
  const Format* chosen = format_of_option(settings.format);
  return chosen != nullptr ? chosen : format_of_extension(path);
}

Box3 ReadSettings::box_m() const {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  if (box.empty()) return {{-kEndless, -kEndless, -kEndless}, {kEndless, kEndless, kEndless}};
  if (box.size() != 6)
    fail(Status::kInvalidArgument,
         "the option \"box\" has %zu numbers; it needs the least x, y, z and the greatest",
         box.size());
  const Box3 out{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
  if (out.empty())
    fail(Status::kInvalidArgument,
         "the option \"box\" has a greatest coordinate below the least; it needs the least x, y, "
         "z, then the greatest");
  return out;
}

Cloud read_cloud(const std::string& path, const ReadSettings& settings, Task& task) {
  const ByteSource source(path);
  const Format& format = format_to_read(source, settings);
  if (format.read_cloud != nullptr) {
    const bool has_levels = format.has_levels || is_copc(source);
    settings.box_m();  // refused before anything is read
    if (settings.spacing_m > 0 && !has_levels)
      fail(Status::kUnsupported,
           "%s: the option \"spacing_m\" is of COPC files and EPT, which have their points in "
           "levels; "
           "read this one whole and subsample it",
           path.c_str());
    Cloud cloud = format.read_cloud(source, settings, task);
    warn_of_single_precision(cloud, source.path(), task);
    cloud = with_station_file(std::move(cloud), source.path(), !has_levels || settings.reads_all(),
                              task);
    if (!format.knows_units) cloud = in_metres(std::move(cloud), settings.unit, task);
    return wanted_points(std::move(cloud), source.path(), settings, task);
  }
  refuse_option(path, settings.format, &Format::read_cloud, "cloud", true);
  const auto models =
      names_of([](const Format& f) { return f.read_model != nullptr && f.read_cloud == nullptr; });
  fail(Status::kUnsupported, "%s: %s hold a model, no cloud", path.c_str(),
       listed(models, " and ").c_str());
}

Model read_model(const std::string& path, const ReadSettings& settings, Task& task) {
  const ByteSource source(path);
  const Format& format = format_to_read(source, settings);
  if (!settings.reads_whole())
    fail(
        Status::kUnsupported,
        "%s: the options \"box\", \"spacing_m\", \"station\", \"max_points\" and \"fields\" are of "
        "clouds",
        path.c_str());
  if (format.read_model != nullptr) return format.read_model(source, settings, task);
  refuse_option(path, settings.format, &Format::read_model, "model", true);
  auto models = names_of([](const Format& f) { return f.read_model != nullptr; });
  std::ranges::sort(models);
  fail(Status::kUnsupported, "%s: no model; models are %s", path.c_str(),
       listed(models, " or ").c_str());
}

void write_cloud(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                 Task& task) {
  const Format* format = format_to_write(path, settings);
  if (format == nullptr || format->write_cloud == nullptr) {
    refuse_option(path, settings.format, &Format::write_cloud, "cloud", false);
    refuse_extension(path, &Format::write_cloud);
  }
  format->write_cloud(cloud, path, settings, task);
  write_station_file(cloud, path, keeps_stations_of(*format, cloud));
}

void write_model(const Model& model, const std::string& path, const WriteSettings& settings,
                 Task& task, const PartAttributes* attributes) {
  const Format* format = format_to_write(path, settings);
  if (format == nullptr || format->write_model == nullptr) {
    refuse_option(path, settings.format, &Format::write_model, "model", false);
    refuse_extension(path, &Format::write_model);
  }
  if (attributes != nullptr && format->write_attributes != nullptr)
    format->write_attributes(model, *attributes, path, settings, task);
  else format->write_model(model, path, settings, task);
}

}  // namespace jalon
