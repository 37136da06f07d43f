// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "base/error.h"
#include "base/params.h"
#include "base/setting_rows.h"

using namespace jalon;

namespace {

struct Sample {
  enum class Method { kVoxel, kRandom };

  double tolerance = 0.025;
  int64_t seed = 1;
  bool adaptive = true;
  std::string name = "facade";
  Method method = Method::kVoxel;
  std::vector<double> up = {0, 0, 1};
};

constexpr auto kRows = setting_rows(
    number_row<&Sample::tolerance>("tolerance", 1e-6, 10, "m", "", "Half-thickness of a plane"),
    integer_row<&Sample::seed>("seed", 0, 9007199254740992.0, "1", "", "Seed"),
    bool_row<&Sample::adaptive>("adaptive", "", "Adaptive draws"),
    string_row<&Sample::name>("name", "", "Name"),
    choice_row<&Sample::method>("method", "voxel|random", "", "Method"),
    doubles_row<&Sample::up>("up", -1, 1, "1", "", "Vertical direction"));

ParamSet make() { return {"test", kRows}; }

Status status_of(auto&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("parameters start with their defaults") {
  const ParamSet set = make();
  CHECK(set.number("tolerance") == 0.025);
  CHECK(set.integer("seed") == 1);
  CHECK(set.flag("adaptive"));
  CHECK(set.text("name") == "facade");
  CHECK(set.text("method") == "voxel");
  CHECK(set.numbers("up") == std::vector<double>{0, 0, 1});
}

TEST_CASE("an unknown name lists the names there are") {
  ParamSet set = make();
  try {
    set.set_number("tolerence", 1);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kNotFound);
    CHECK(std::string(error.what()).find("tolerance, seed") != std::string::npos);
  }
}

TEST_CASE(
    "values out of range, of the wrong type and NaN are refused when set, and change nothing") {
  ParamSet set = make();
  CHECK(status_of([&] { set.set_number("tolerance", 0); }) == Status::kInvalidArgument);
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CHECK(status_of([&] { set.set_number("tolerance", value); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.set_number("seed", 1.5); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.set_integer("adaptive", 1); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.set_text("method", "Voxel"); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.set_text("tolerance", "0.1"); }) == Status::kInvalidArgument);
  const double steep[] = {0, 0, 2};
  CHECK(status_of([&] { set.set_numbers("up", steep); }) == Status::kInvalidArgument);
  CHECK(set.to_json() == make().to_json());
}

TEST_CASE("whole numbers pass between integer and double rows") {
  ParamSet set = make();
  set.set_integer("tolerance", 2);
  CHECK(set.number("tolerance") == 2.0);
  set.set_number("seed", 7.0);
  CHECK(set.integer("seed") == 7);
}

TEST_CASE("JSON out and in gives the same values") {
  ParamSet set = make();
  set.set_number("tolerance", 0.1);
  set.set_integer("seed", 9007199254740991);
  set.set_bool("adaptive", false);
  set.set_text("name", "Fa\u00e7ade \"A\"\n");
  set.set_text("method", "random");
  const double up[] = {0.1, -0.2, 1.0 / 3};
  set.set_numbers("up", up);
  ParamSet other = make();
  other.from_json(set.to_json());
  CHECK(other.to_json() == set.to_json());
  CHECK(other.numbers("up")[2] == 1.0 / 3);
}

TEST_CASE("JSON with one bad value sets none of them") {
  ParamSet set = make();
  const std::string before = set.to_json();
  CHECK(status_of([&] { set.from_json(R"({"tolerance": 0.5, "seed": -1})"); }) ==
        Status::kInvalidArgument);
  CHECK(status_of([&] { set.from_json(R"({"tolerance": 0.5, "nose": 1})"); }) == Status::kNotFound);
  CHECK(status_of([&] { set.from_json(R"({"tolerance": 0.5)"); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.from_json("[1, 2]"); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.from_json(R"({"up": [0, "1", 2]})"); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { set.from_json(R"({"tolerance": null})"); }) == Status::kInvalidArgument);
  CHECK(set.to_json() == before);
}

TEST_CASE("reset brings the defaults back") {
  ParamSet set = make();
  set.set_number("tolerance", 1);
  set.reset();
  CHECK(set.to_json() == make().to_json());
}
