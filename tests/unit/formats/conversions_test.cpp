// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What README says of conversions: each pair of formats keeps of a cloud what the table tells of the one written.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "formats/codecs/codecs.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr size_t kPoints = 40;
constexpr double kLasStep_m = 0.0001;  // where the option "scale" says none

/// A row of the table: a format, and what it does not keep.
struct Kept {
  std::string extension;
  double step_m;
  bool keeps_crs;
};

std::vector<Kept> rows() {
  std::vector<Kept> out{{"las", kLasStep_m, true}, {"ply", 0, true},
                        {"pcd", 0, true},          {"xyz", 0, true},
                        {"csv", 0, false},         {"ept.json", kLasStep_m, true},
                        {"pts", 0, true}};
  if (!has_codecs()) return out;
  out.push_back({"laz", kLasStep_m, true});
  out.push_back({"copc.laz", kLasStep_m, true});
  out.push_back({"e57", 0, true});
  return out;
}

/// Points of two stations on a national grid; "number" tells them apart.
Cloud scan() {
  Cloud cloud = random_points(kPoints, 23);
  RandomStream random(23, 4);
  cloud.crs = "EPSG:2154";
  auto number =
      std::make_shared<Column>(FieldInfo{"number", ElementType::kInt32, 1, "", ""}, kPoints);
  for (size_t i = 0; i < kPoints; ++i) number->values<int32_t>()[i] = static_cast<int32_t>(i);
  cloud.fields.set(number);
  for (const char* name : {"red", "green", "blue"})
    cloud.fields.set(random_column(name, ElementType::kUint8, 1, kPoints, random));
  cloud.fields.set(random_column("intensity", ElementType::kUint16, 1, kPoints, random));
  cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, kPoints, random));
  cloud.fields.set(random_column("own", ElementType::kFloat64, 1, kPoints, random));
  cloud.fields.set(random_column("gps_time", ElementType::kFloat64, 1, kPoints, random));
  auto classes = std::make_shared<Column>(
      FieldInfo{"classification", ElementType::kUint8, 1, "", ""}, kPoints);
  for (size_t i = 0; i < kPoints; ++i) classes->values<uint8_t>()[i] = static_cast<uint8_t>(i % 20);
  cloud.fields.set(classes);
  for (const uint64_t first : {0, 25}) {
    Station& station = cloud.stations.emplace_back();
    station.name = first == 0 ? "west" : "east";
    station.has_pose = true;
    station.pose.m[3] = 652000 + static_cast<double>(first);
    station.pose.m[7] = 6861000;
    station.pose.m[11] = 101.5;
    station.first = first;
    station.count = first == 0 ? 25 : kPoints - 25;
  }
  return cloud;
}

/// The point of b that each of a is: by its number where both have one (COPC and EPT sort), else by its place.
std::vector<size_t> partners(const Cloud& a, const Cloud& b) {
  const Column *of_a = a.fields.find("number"), *of_b = b.fields.find("number");
  std::vector<size_t> out(a.size());
  for (size_t i = 0; i < a.size(); ++i) {
    const auto is_same = [&](size_t k) {
      return of_a != nullptr && of_b != nullptr ? of_a->number(i, 0) == of_b->number(k, 0)
                                                : norm(a.point(i) - b.point(k)) < 0.001;
    };
    while (out[i] < b.size() && !is_same(out[i])) ++out[i];
    REQUIRE(out[i] < b.size());
  }
  return out;
}

bool same_field(const Column& a, const Column& b, const std::vector<size_t>& partner) {
  for (size_t i = 0; i < partner.size(); ++i)
    for (uint32_t c = 0; c < a.info().components; ++c)
      if (static_cast<float>(a.number(i, c)) != static_cast<float>(b.number(partner[i], c)))
        return false;
  return a.info().components == b.info().components;
}

void check_kept(const Cloud& from, const Cloud& to, const Kept& row) {
  REQUIRE(to.size() == from.size());
  const std::vector<size_t> partner = partners(from, to);
  for (size_t i = 0; i < from.size(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(std::fabs(to.point(partner[i])[k] - from.point(i)[k]) <= 0.5 * row.step_m + 2e-9);
  for (const ColumnPtr& column : from.fields) {
    const std::string& name = column->info().name;
    CAPTURE(name);
    const Column* found = to.fields.find(name);
    REQUIRE(found != nullptr);
    CHECK(same_field(*column, *found, partner));
  }
  CHECK(to.crs.empty() == (!row.keeps_crs || from.crs.empty()));
  REQUIRE(to.stations.size() == from.stations.size());
  for (const Station& station : from.stations) {
    const auto same = std::ranges::find(to.stations, station.name, &Station::name);
    REQUIRE(same != to.stations.end());
    CHECK(same->count == station.count);
    REQUIRE(same->has_pose);
    for (size_t i = 0; i < 12; ++i) CHECK(std::fabs(same->pose.m[i] - station.pose.m[i]) < 1e-6);
  }
}

}  // namespace

TEST_CASE("conversions__each_pair_keeps_what_the_table_of_the_readme_says") {
  for (const Kept& source : rows()) {
    const Folder from;
    const std::string name = source.extension == "ept.json" ? "" : "a.";
    write(scan(), from.file(name + source.extension));
    const Cloud whole = read(from.file(name + source.extension));
    CAPTURE(source.extension);
    check_kept(scan(), whole, source);
    for (const Kept& target : rows()) {
      CAPTURE(target.extension);
      const Folder to;
      const std::string stem = target.extension == "ept.json" ? "" : "b.";
      const std::string path = to.file(stem + target.extension);
      Task task;
      CHECK(convert_cloud(from.file(name + source.extension), path, {}, task) == kPoints);
      check_kept(whole, read(path), target);
    }
  }
}
