// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "base/settings_json.h"

using namespace jalon;

namespace {

enum class Keep { kNearest, kFirst, kMean };

struct Inner {
  double margin_m = 0.25;
  std::vector<double> centre = {1, 2};
};
struct Outer {
  double spacing_m = 0.02;
  Keep keep = Keep::kFirst;
  uint32_t most = 7;
  bool has_mean = true;
  std::string field = "normal";
  Inner inner = {.margin_m = 3};
};
struct Other {
  double spacing_m = 0.02;
};

constexpr auto kInner = setting_rows(number_row<&Inner::margin_m>("margin_m", 0, 10, "m", "", ""),
                                     doubles_row<&Inner::centre>("centre", 0, 9, "m", "", ""));
constexpr auto kOuter =
    setting_rows(number_row<&Outer::spacing_m>("spacing_m", 0, 1, "m", "", ""),
                 choice_row<&Outer::keep>("keep", "nearest|first|mean", "", ""),
                 integer_row<&Outer::most>("most", 0, 10, "1", "", ""),
                 bool_row<&Outer::has_mean>("has_mean", "", ""),
                 string_row<&Outer::field>("field", "", ""), nested_rows<&Outer::inner, kInner>());

}  // namespace

TEST_CASE("setting_rows__defaults_are_the_initialisers_of_the_members") {
  const ParamSet set("test", kOuter);
  CHECK(set.to_json() ==
        R"({"spacing_m":0.02,"keep":"first","most":7,"has_mean":true,"field":"normal",)"
        R"("margin_m":3.0,"centre":[1.0,2.0]})");
}

TEST_CASE("setting_rows__what_is_set_reaches_the_members") {
  ParamSet set("test", kOuter);
  set.from_json(R"({"spacing_m":0.5,"keep":"mean","most":3,"has_mean":false,"field":"x",)"
                R"("margin_m":4,"centre":[]})");
  const auto settings = settings_from<Outer>(set);
  CHECK(settings.spacing_m == 0.5);
  CHECK(settings.keep == Keep::kMean);
  CHECK(settings.most == 3);
  CHECK_FALSE(settings.has_mean);
  CHECK(settings.field == "x");
  CHECK(settings.inner.margin_m == 4);
  CHECK(settings.inner.centre.empty());
}

TEST_CASE("setting_rows__a_struct_becomes_the_json_of_its_table") {
  Outer settings;
  settings.keep = Keep::kNearest;
  settings.inner.margin_m = 1;
  ParamSet set("test", kOuter);
  set.set_text("keep", "nearest");
  set.set_number("margin_m", 1);
  CHECK(settings_json(kOuter, settings) == set.to_json());
}

TEST_CASE("setting_rows__a_nested_table_starts_from_the_outer_struct") {
  CHECK(ParamSet("test", kInner).number("margin_m") == 0.25);
  CHECK(ParamSet("test", kOuter).number("margin_m") == 3);
}

TEST_CASE("setting_rows__settings_of_another_struct_are_refused") {
  const ParamSet set("test", kOuter);
  CHECK_THROWS_AS(settings_from<Other>(set), Error);
  CHECK_THROWS_AS(settings_json(kOuter, Other{}), Error);
}
