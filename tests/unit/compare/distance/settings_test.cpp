// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The parameters of method "distance": what users write against what the struct holds.
#include "compare/distance/settings.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/params.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

ParamSet fresh() { return {"method distance", distance_rows()}; }

}  // namespace

TEST_CASE("distance_rows__reach_each_its_member_and_no_other") {
  // Every row is changed alone; what is read back has that value and all others their defaults.
  std::set<std::string> names;
  for (const ParamRow& row : distance_rows()) {
    CHECK(names.insert(row.name).second);
    ParamSet set = fresh();
    const std::string before = set.to_json();
    switch (row.type) {
      case ParamType::kDouble:
        set.set_number(row.name, set.number(row.name) == row.minimum ? row.maximum : row.minimum);
        break;
      case ParamType::kInt64:
        set.set_integer(row.name, 3);
        break;
      case ParamType::kBool:
        set.set_bool(row.name, !set.flag(row.name));
        break;
      case ParamType::kChoice:
        set.set_text(row.name, choice_at(row, set.text(row.name) == choice_at(row, 0) ? 1 : 0));
        break;
      default:
        continue;
    }
    const auto settings = settings_from<DistanceSettings>(set);
    for (const ParamRow& other : distance_rows()) {
      const ParamValue is = other.save(other, &settings), was = other.initial(other);
      const bool same = is.number == was.number && is.integer == was.integer &&
                        is.flag == was.flag && is.text == was.text && is.numbers == was.numbers;
      CHECK_MESSAGE(same == (std::string(row.name) != other.name), row.name, " and ", other.name);
    }
    CHECK(set.to_json() != before);
  }
  CHECK(names.count("hidden") == 1);  // those of visibility are nested
}

TEST_CASE("distance_settings__take_eight_points_for_a_plane_sixteen_for_others_or_those_given") {
  DistanceSettings settings;
  struct {
    LocalModelKind kind;
    uint32_t points;
  } const rows[] = {
      {LocalModelKind::kPlane, 8}, {LocalModelKind::kDelaunay, 16}, {LocalModelKind::kQuadric, 16}};
  for (const auto& row : rows) {
    settings.local_model = row.kind;
    settings.k = 0;
    CHECK(settings.model_points() == row.points);
    settings.k = 5;
    CHECK(settings.model_points() == 5);
  }
}

TEST_CASE("distance_settings__have_no_limit_at_0_and_refuse_what_is_out_of_range") {
  DistanceSettings settings;
  CHECK(std::isinf(settings.limit_m()));
  settings.max_distance_m = 0.25;
  CHECK(settings.limit_m() == 0.25);
  ParamSet set = fresh();
  CHECK(refuses([&] { set.set_number("max_distance_m", -1); }, Status::kInvalidArgument,
                "max_distance_m"));
  CHECK(refuses([&] { set.set_integer("k", 257); }, Status::kInvalidArgument, "k"));
  CHECK(refuses([&] { set.set_text("local_model", "spline"); }, Status::kInvalidArgument,
                "none|plane|delaunay|quadric"));
  set.set_text("local_model", "quadric");
  set.set_text("neighbourhood", "point");
  const auto read = settings_from<DistanceSettings>(set);
  CHECK(read.local_model == LocalModelKind::kQuadric);
  CHECK(read.neighbourhood == DistanceSettings::Neighbourhood::kPoint);
}
