// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/target_catalogue.h"

#include "base/error.h"
#include "base/json_reader.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kLeastSize_m = 0.005, kMostSize_m = 2;
constexpr double kMostSizeSigma_m = 0.1;
constexpr size_t kMostEntries = 1000;

double length_member(const JsonValue& object, const char* what, double least_m, double most_m) {
  const JsonValue* value = find_member(object, what);
  if (value == nullptr || !value->is_number() ||
      !(value->number >= least_m && value->number <= most_m))
    fail(Status::kFormat, "target catalogue: \"%s\" is a length from %s to %s m", what,
         text_of(least_m).c_str(), text_of(most_m).c_str());
  return value->number;
}

// A code may be written as a number: 3 is "3".
std::string code_of(const JsonValue& object) {
  const JsonValue* value = find_member(object, "code");
  const bool is_code = value != nullptr && (value->kind == JsonValue::Kind::kText ||
                                            value->kind == JsonValue::Kind::kInteger);
  if (!is_code || value->text.empty() ||
      value->text.find_first_of(";,\"\r\n\t") != std::string::npos)
    fail(Status::kFormat,
         "target catalogue: each target has a \"code\", a number or a text without separators");
  return value->text;
}

TargetKind kind_of(const JsonValue& object) {
  const JsonValue* value = find_member(object, "kind");
  const std::string kind = value != nullptr ? value->text : "";
  if (kind == "checker") return TargetKind::kChecker;
  if (kind == "disc") return TargetKind::kDisc;
  fail(Status::kFormat,
       "target catalogue: \"kind\" of a target is checker or disc: nothing else shows in the "
       "intensities of a whole scan");
}

CatalogueEntry entry_of(const JsonValue& object) {
  if (object.kind != JsonValue::Kind::kObject)
    fail(Status::kFormat, "target catalogue: \"targets\" holds objects");
  CatalogueEntry out;
  out.code = code_of(object);
  out.kind = kind_of(object);
  out.size_m = length_member(object, "size_m", kLeastSize_m, kMostSize_m);
  if (const JsonValue* name = find_member(object, "name")) out.name = name->text;
  return out;
}

}  // namespace

TargetCatalogue target_catalogue_from_json(std::string_view text) {
  const std::vector<JsonValue> read = read_json(text);
  const JsonValue& top = read.front();
  if (top.kind != JsonValue::Kind::kObject)
    fail(Status::kFormat, "target catalogue: no JSON object");
  TargetCatalogue out;
  if (find_member(top, "size_sigma_m") != nullptr)
    out.size_sigma_m = length_member(top, "size_sigma_m", 0, kMostSizeSigma_m);
  const JsonValue* targets = find_member(top, "targets");
  if (targets == nullptr || targets->kind != JsonValue::Kind::kArray)
    fail(Status::kFormat, "target catalogue: no list \"targets\"");
  for (const JsonValue& target : JsonChildren(*targets)) out.entries.push_back(entry_of(target));
  if (out.entries.empty()) fail(Status::kFormat, "target catalogue: no target in it");
  if (out.entries.size() > kMostEntries)
    fail(Status::kFormat, "target catalogue: at most %zu targets", kMostEntries);
  return out;
}

}  // namespace jalon
