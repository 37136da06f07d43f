// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/notes.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

using Json = nlohmann::ordered_json;

const Json* object_at(const Json& notes, const char* name) {
  const auto it = notes.find(name);
  if (it == notes.end()) return nullptr;
  if (!it->is_object()) fail(Status::kInvalidArgument, "\"%s\" of the notes is not a JSON object", name);
  return &*it;
}

std::string text_value(const std::string& name, const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  if (value.is_number()) return text_of(value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  fail(Status::kInvalidArgument, "\"%.100s\" in the notes' input is no text", name.c_str());
}

}  // namespace

Notes read_notes(std::string_view json) {
  Notes out;
  if (json.empty()) return out;
  const Json notes = Json::parse(json, nullptr, /*allow_exceptions=*/false);
  if (!notes.is_object()) fail(Status::kInvalidArgument, "the notes are not one JSON object");
  if (const auto it = notes.find("title"); it != notes.end()) {
    if (!it->is_string()) fail(Status::kInvalidArgument, "\"title\" of the notes is no text");
    out.title = it->get<std::string>();
  }
  if (const Json* input = object_at(notes, "input"))
    for (const auto& [name, value] : input->items()) out.input.emplace_back(name, text_value(name, value));
  if (const Json* times = object_at(notes, "times"))
    for (const auto& [name, value] : times->items()) {
      if (!value.is_number() || !std::isfinite(value.get<double>()))
        fail(Status::kInvalidArgument, "\"%.100s\" in the notes' times is no number of seconds", name.c_str());
      out.times_s.emplace_back(name, value.get<double>());
    }
  return out;
}

}  // namespace jalon
