// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/names/notes.h"

#include <map>

#include "base/error.h"
#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/text_number.h"

namespace jalon {

namespace {

using Kind = JsonValue::Kind;

// The members of an object of the notes; none when it is not there.
std::vector<const JsonValue*> members_of(const JsonValue& notes, const char* name) {
  std::vector<const JsonValue*> members;
  const JsonValue* object = find_member(notes, name);
  if (object == nullptr) return members;
  if (object->kind != Kind::kObject)
    fail(Status::kInvalidArgument, "\"%s\" of the notes is not a JSON object", name);
  for (const JsonValue& member : JsonChildren(*object)) members.push_back(&member);
  return members;
}

std::string text_value(const JsonValue& value) {
  if (value.kind == Kind::kText || value.kind == Kind::kInteger) return value.text;
  if (value.kind == Kind::kNumber) return text_of(value.number);
  if (value.kind == Kind::kBool) return value.flag ? "yes" : "no";
  fail(Status::kInvalidArgument, "\"%.100s\" in the notes' input is no text", value.name.c_str());
}

// Every name once, with the value given last, in the order of first mention.
template <class T>
class Pairs {
 public:
  explicit Pairs(std::vector<std::pair<std::string, T>>& out) : out_(out) {}
  void put(const std::string& name, T value) {
    const auto [at, is_new] = places_.emplace(name, out_.size());
    if (is_new) out_.emplace_back(name, std::move(value));
    else out_[at->second].second = std::move(value);
  }

 private:
  std::vector<std::pair<std::string, T>>& out_;
  std::map<std::string, size_t> places_;
};

}  // namespace

Notes read_notes(std::string_view json) {
  Notes out;
  if (json.empty()) return out;
  const std::vector<JsonValue> values = read_json(json);
  const JsonValue& notes = values[0];
  if (notes.kind != Kind::kObject)
    fail(Status::kInvalidArgument, "the notes are not one JSON object");
  if (const JsonValue* title = find_member(notes, "title")) {
    if (title->kind != Kind::kText)
      fail(Status::kInvalidArgument, "\"title\" of the notes is no text");
    out.title = title->text;
  }
  Pairs input(out.input);
  for (const JsonValue* member : members_of(notes, "input"))
    input.put(member->name, text_value(*member));
  members_of(notes, "scanner");  // refuses what is no object
  if (const JsonValue* scanner = find_member(notes, "scanner"))
    out.scanner_json = JsonWriter().value(*scanner).take();
  Pairs times(out.times_s);
  for (const JsonValue* member : members_of(notes, "times")) {
    if (!member->is_number())
      fail(Status::kInvalidArgument, "\"%.100s\" in the notes' times is no number of seconds",
           member->name.c_str());
    times.put(member->name, member->number);
  }
  return out;
}

}  // namespace jalon
