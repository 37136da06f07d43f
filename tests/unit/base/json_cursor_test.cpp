// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_cursor.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/error.h"

using namespace jalon;

namespace {

class Listener : public JsonListener {
 public:
  void refuse(uint64_t byte, const char* expected) const override {
    fail(Status::kFormat, "%s at %llu", expected, static_cast<unsigned long long>(byte));
  }
  void tick() const override { ++ticks; }
  mutable int ticks = 0;
};

// What the walk ends with: "" or the refusal.
template <class F>
std::string refusal(std::string_view text, F&& walk) {
  const Listener listener;
  JsonCursor cursor(text, listener);
  try {
    walk(cursor);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("json_cursor__walks_members_and_elements_in_the_order_of_the_text") {
  const Listener listener;
  JsonCursor cursor("\xEF\xBB\xBF {\"a\" : [1, 2.5, -3e2], \"b\":{\"x\":null}, \"c\" :true} \n",
                    listener);
  std::string name, names;
  double sum = 0;
  cursor.begin_object();
  while (cursor.next_member(name)) {
    names += name;
    if (name == "a")
      for (cursor.begin_array(); cursor.next_element();) sum += cursor.number();
    else if (name == "b") CHECK(cursor.skip() == "{\"x\":null}");
    else CHECK(cursor.flag());
  }
  cursor.end();
  CHECK(names == "abc");
  CHECK(sum == 1 + 2.5 - 300);
}

TEST_CASE("json_cursor__another_kind_than_asked_for_is_refused_where_it_stands") {
  using C = JsonCursor;
  CHECK(refusal("  \"x\"", [](C& c) { c.number(); }) == "a number at 2");
  CHECK(refusal("[1]", [](C& c) { c.begin_object(); }) == "an object at 0");
  CHECK(refusal(" 1", [](C& c) { c.text(); }) == "a text in quotes at 1");
  CHECK(refusal("1.0", [](C& c) { c.integer(); }).starts_with("a whole number at "));
  CHECK(refusal("1e400", [](C& c) { c.number(); }).starts_with("a number that a double holds"));
  CHECK(refusal("true 1", [](C& c) { c.flag(), c.end(); }) == "the end of the text at 5");
  CHECK(refusal("truth", [](C& c) { c.flag(); }) == "a value at 0");
  CHECK(refusal("[1 2]", [](C& c) {
          for (c.begin_array(); c.next_element();) c.number();
        }) == "a comma or the end of the values at 3");
}

TEST_CASE("json_cursor__skip_checks_what_it_passes_over") {
  for (const char* bad : {"[1,]", "{\"a\" 1}", "{\"a\":01}", "\"\\q\"", "\"\xC3\"", "[\"\\uD800\"]",
                          "[1", "{", "nul", "-", "1.", "{1:2}"})
    CHECK_MESSAGE(refusal(bad, [](JsonCursor& c) { c.skip(), c.end(); }) != "", bad);
  for (const char* good : {"[ ]", "{}", "-0.5e+7", "\"\\u00e9\\n\"", "[[],{\"a\":[null]}]"})
    CHECK_MESSAGE(refusal(good, [](JsonCursor& c) { c.skip(), c.end(); }) == "", good);
}

TEST_CASE("json_cursor__levels_end_at_64_and_long_texts_tick") {
  const auto nested = [](size_t n) { return std::string(n, '[') + std::string(n, ']'); };
  const auto skip = [](JsonCursor& c) { c.skip(); };
  CHECK(refusal(nested(64), skip) == "");
  CHECK(refusal(nested(65), skip) != "");
  std::string text = "[0";
  for (int i = 0; i < 50000; ++i) text += ",1";
  text += ']';
  const Listener listener;
  JsonCursor cursor(text, listener);
  CHECK(cursor.skip().size() == text.size());
  CHECK(listener.ticks >= 2);
}
