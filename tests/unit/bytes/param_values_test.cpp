// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/param_values.h"

#include <doctest/doctest.h>

#include <limits>

#include "base/setting_rows.h"

namespace jalon {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

struct Before {
  double length_m = 0.1;
  int64_t count = 3;
  bool is_closed = false;
  std::string name = "n";
  std::vector<double> numbers = {1, 0.1};
};
constexpr auto kBefore =
    setting_rows(number_row<&Before::length_m>("length_m", 0, kUnlimited, "m", "", "A length."),
                 integer_row<&Before::count>("count", 0, 9, "", "", "A count."),
                 bool_row<&Before::is_closed>("is_closed", "", "A switch."),
                 string_row<&Before::name>("name", "", "A text."),
                 doubles_row<&Before::numbers>("numbers", -1, 1, "", "", "Numbers."));

// A later release: another default and range, a row more, one less.
struct After {
  double length_m = 0.2;
  int64_t count = 3;
  double new_m = 7;
};
constexpr auto kAfter =
    setting_rows(number_row<&After::length_m>("length_m", 0, 5, "m", "", "A length."),
                 integer_row<&After::count>("count", 0, 9, "", "", "A count."),
                 number_row<&After::new_m>("new_m", 0, 9, "m", "", "A new length."));

std::string values_read_back(const ParamSet& from, ParamSet& to) {
  Task task;
  ByteWriter writer;
  write_values(writer, from);
  const Buffer<uint8_t> whole = writer.sealed(BytesKind::kParams, task);
  ByteReader reader({whole.data(), whole.size()}, BytesKind::kParams, task);
  try {
    read_values(reader, to);
    reader.end();
  } catch (const Error& error) {
    CHECK(error.status() == Status::kFormat);
    return error.what();
  }
  return "";
}

TEST_CASE("param_values__of_all_types_come_back") {
  ParamSet params("test", kBefore), back("test", kBefore);
  params.set_number("length_m", kUnlimited);
  params.set_integer("count", 9);
  params.set_bool("is_closed", true);
  params.set_text("name", "");
  params.set_numbers("numbers", std::vector<double>{-0.0, 1.0 / 3});
  CHECK(values_read_back(params, back) == "");
  CHECK(back.to_json() == params.to_json());
  CHECK(std::signbit(back.numbers("numbers")[0]));
}

TEST_CASE("param_values__of_an_earlier_release_mean_what_they_meant_then") {
  struct Small {
    double length_m = 0.1;
    int64_t count = 3;
  };
  static constexpr auto kSmall =
      setting_rows(number_row<&Small::length_m>("length_m", 0, kUnlimited, "m", "", "A length."),
                   integer_row<&Small::count>("count", 0, 9, "", "", "A count."));
  ParamSet small("test", kSmall), after("test", kAfter);
  CHECK(values_read_back(small, after) == "");
  CHECK(after.number("length_m") == 0.1);  // the default of then
  CHECK(after.number("new_m") == 7);
  small.set_number("length_m", 6);
  CHECK(values_read_back(small, after).find("outside") != std::string::npos);
}

TEST_CASE("param_values__that_are_gone_or_of_another_type_are_named") {
  ParamSet before("test", kBefore), after("test", kAfter);
  CHECK(values_read_back(before, after).find("no parameter \"is_closed\"") != std::string::npos);
  struct Other {
    std::string length_m;
  };
  static constexpr auto kOther =
      setting_rows(string_row<&Other::length_m>("length_m", "", "A text."));
  ParamSet other("test", kOther);
  CHECK(values_read_back(other, after).find("is of type 1 here, not 4") != std::string::npos);
}

}  // namespace
}  // namespace jalon
