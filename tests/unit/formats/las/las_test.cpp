// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>

#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr ElementType kAllTypes[] = {
    ElementType::kInt8,    ElementType::kUint8,  ElementType::kInt16, ElementType::kUint16,
    ElementType::kInt32,   ElementType::kUint32, ElementType::kInt64, ElementType::kUint64,
    ElementType::kFloat32, ElementType::kFloat64};

double largest_difference(const Cloud& a, const Cloud& b) {
  double largest = 0;
  for (size_t i = 0; i < 3 * a.size(); ++i)
    largest = std::max(largest, std::fabs(a.xyz()[i] - b.xyz()[i]));
  return largest;
}

// The VLRs of a file as one text, header bytes included.
std::string vlr_bytes(const std::string& file) {
  const uint16_t header = load<uint16_t>(file.data() + 94);
  return file.substr(header, load<uint32_t>(file.data() + 96) - header);
}

std::string header_of_points(unsigned format, uint16_t record, uint32_t count) {
  std::string bytes(227, '\0');
  std::memcpy(bytes.data(), "LASF", 4);
  bytes[24] = 1;
  bytes[25] = 2;
  store<uint16_t>(bytes.data() + 94, 227);
  store<uint32_t>(bytes.data() + 96, 227);
  bytes[104] = static_cast<char>(format);
  store<uint16_t>(bytes.data() + 105, record);
  store<uint32_t>(bytes.data() + 107, count);
  for (int k = 0; k < 3; ++k) store<double>(bytes.data() + 131 + 8 * k, 0.01);
  return bytes;
}

}  // namespace

TEST_CASE("las__round_trip_keeps_random_fields_of_every_type_and_coordinates_within_half_a_step") {
  const Folder folder;
  size_t columns = 0;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, 2);
    const size_t n = seed == 0 ? 0 : 1 + random.below(3000);
    Cloud cloud = random_points(n, seed);
    const size_t fields = random.below(6);
    for (size_t f = 0; f < fields; ++f) {
      const ElementType type = kAllTypes[random.below(10)];
      const auto components = 1 + static_cast<uint32_t>(random.below(3));
      cloud.fields.set(random_column("field " + std::to_string(f), type, components, n, random));
    }
    cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, n, random));
    cloud.fields.set(random_column(
        "intensity", seed % 2 == 0 ? ElementType::kUint16 : ElementType::kFloat32, 1, n, random));
    cloud.fields.set(random_column("classification", ElementType::kUint8, 1, n, random));
    cloud.crs = seed % 4 == 0   ? ""
                : seed % 4 == 1 ? "EPSG:2154"
                : seed % 4 == 2
                    ? "urn:ogc:def:crs:EPSG::2154"
                    : "PROJCS[\"RGF93\",GEOGCS[\"g\",UNIT[\"degree\",0.01745]],UNIT[\"metre\",1]]";
    WriteSettings settings;
    if (seed % 3 == 1) settings.las_version = LasVersion::k12;
    if (seed % 3 == 2) settings.las_version = LasVersion::k14;
    if (seed % 3 == 1 && seed % 4 == 3)
      continue;  // WKT in 1.2 is allowed too, but not what this test is about
    write(cloud, folder.file("a.las"), settings);
    const Cloud back = read(folder.file("a.las"));
    REQUIRE(back.size() == n);
    CHECK(largest_difference(cloud, back) <= 0.5 * 0.0001 + 1e-9);
    CHECK(back.crs.str() == cloud.crs.str());
    for (const ColumnPtr& column : cloud.fields) {
      const Column* other = back.fields.find(column->info().name);
      REQUIRE_MESSAGE(other != nullptr, column->info().name);
      CHECK_MESSAGE(same_values(*column, *other), "seed ", seed, " field ", column->info().name,
                    " ", name_of(column->info().type));
      ++columns;
    }
  }
  MESSAGE("columns compared: ", columns);
}

TEST_CASE("las__keeps_vlrs_crs_and_coordinates_of_a_file_byte_for_byte") {
  for (const char* name : {"las/autzen_trim.las", "las/extrabytes.las", "las/test1_4.las",
                           "las/interesting.las", "las/1.2-with-color.las"}) {
    const std::string path = shared(name);
    if (path.empty()) return;
    const Folder folder;
    const Cloud cloud = read(path);
    write(cloud, folder.file("a.las"));
    const std::string before = slurp(path), after = slurp(folder.file("a.las"));
    const Cloud back = read(folder.file("a.las"));
    CHECK(back.crs.str() == cloud.crs.str());
    REQUIRE(back.size() == cloud.size());
    CHECK(largest_difference(cloud, back) <= 1e-9);
    REQUIRE(back.fields.size() >= cloud.fields.size());
    for (const ColumnPtr& column : cloud.fields)
      CHECK(same_values(*column, back.fields.require(column->info().name)));
    REQUIRE(back.attachments->size() == cloud.attachments->size());
    size_t vlr_count = 0;
    for (size_t i = 0; i < cloud.attachments->size(); ++i) {
      if ((*cloud.attachments)[i].key == "las:header") continue;
      CHECK((*cloud.attachments)[i].bytes == (*back.attachments)[i].bytes);
      ++vlr_count;
    }
    CHECK(load<double>(before.data() + 131) == load<double>(after.data() + 131));
    MESSAGE(std::string(name), ": ", cloud.size(), " points, ", cloud.fields.size(), " fields, ",
            vlr_count, " records, LAS 1.", int{after[25]}, " format ", int{after[104]},
            " written, VLRs equal: ",
            vlr_bytes(before).starts_with(vlr_bytes(after)) || vlr_count == 0);
  }
}

TEST_CASE("las__every_shared_file_behaves_as_its_description_says") {
  if (shared("las").empty()) return;
  const auto points = [](const char* name) {
    return read(shared(std::string("las/") + name)).size();
  };
  for (const char* name : {"1.0_0", "1.0_1", "1.1_0", "1.1_1", "1.2_0", "1.2_1", "1.2_2", "1.2_3"})
    CHECK(points((std::string("permutation_") + name + ".las").c_str()) == 1);
  CHECK(points("1.2-with-color.las") == 1065);
  CHECK(points("interesting.las") == 1065);
  CHECK(points("extrabytes.las") == 1065);
  CHECK(points("test1_4.las") == 1000);
  CHECK(points("autzen_trim.las") == 110000);
  CHECK(points("no-points.las") == 0);
  CHECK(points("spurious.las") == 1065);
  CHECK(points("bad_vlr_count.las") == 10);
  const Cloud nan = read(shared("las/gps-time-nan.las"));
  REQUIRE(nan.size() == 1);
  CHECK(std::isnan(nan.fields.require("gps_time").number(0)));
  const Failure broken = failure_of([] { read(shared("las/garbage_nVariableLength.las")); });
  CHECK(broken.status == Status::kFormat);
  CHECK(broken.text.find("719 points") != std::string::npos);
  CHECK(broken.text.find("offset 227") != std::string::npos);
  MESSAGE(broken.text);
  for (const char* name : {"las/autzen_trim.laz", "las/simple.laz"})
    CHECK(failure_of([&] { read(shared(name)); }).status ==
          (has_codecs() ? Status::kOk : Status::kUnsupported));
}

TEST_CASE("las__warns_about_a_broken_vlr_and_loads_the_points") {
  const std::string path = shared("las/bad_vlr_count.las");
  if (path.empty()) return;
  std::string warnings;
  Task::Hooks hooks;
  hooks.log = [](int32_t level, const char* text, void* user) {
    if (level == Task::kWarning) *static_cast<std::string*>(user) += text;
  };
  hooks.log_user = &warnings;
  Task task(hooks);
  CHECK(read_cloud(path, {}, task).size() == 10);
  CHECK(warnings.find("VLR 3 of 3") != std::string::npos);
}

TEST_CASE("las__converts_feet_by_the_crs_and_writes_feet_again") {
  const std::string path = shared("las/autzen_trim.las");
  if (path.empty()) return;
  const Cloud cloud = read(path);  // its CRS is in international feet
  const std::string bytes = slurp(path);
  const double x_feet = load<int32_t>(bytes.data() + load<uint32_t>(bytes.data() + 96)) * 0.01;
  CHECK(cloud.point(0).x == doctest::Approx(x_feet * 0.3048).epsilon(1e-12));
  ReadSettings settings;
  settings.unit = FileUnit::kMetres;
  CHECK(read(path, settings).point(0).x == doctest::Approx(x_feet).epsilon(1e-12));
  MESSAGE("first point ", x_feet, " ft = ", cloud.point(0).x, " m");
}

TEST_CASE("las__restores_the_described_extra_bytes") {
  const std::string path = shared("las/extrabytes.las");
  if (path.empty()) return;
  const Cloud cloud = read(path);
  const Column& colors = cloud.fields.require("Colors");
  CHECK(colors.info().components == 3);
  CHECK(colors.info().type == ElementType::kUint16);
  for (size_t i = 0; i < cloud.size(); ++i) {
    CHECK(colors.number(i, 0) == cloud.fields.require("red").number(i));
    CHECK(colors.number(i, 2) == cloud.fields.require("blue").number(i));
  }
}

TEST_CASE("las__chooses_1_4_only_where_1_2_cannot_hold_the_fields") {
  const Folder folder;
  const auto version_with = [&](const char* name, uint16_t value) {
    Cloud cloud = random_points(3, 1);
    const uint16_t values[] = {1, 2, value};
    cloud.fields.set(make_column<uint16_t>({name}, values));
    write(cloud, folder.file("a.las"));
    const std::string bytes = slurp(folder.file("a.las"));
    CHECK(read(folder.file("a.las")).fields.require(name).number(2) == value);
    return std::pair{int{bytes[25]}, int{bytes[104]}};
  };
  CHECK(version_with("classification", 31) == std::pair{2, 0});
  CHECK(version_with("classification", 32) == std::pair{4, 6});
  CHECK(version_with("return_number", 7) == std::pair{2, 0});
  CHECK(version_with("return_number", 8) == std::pair{4, 6});
  CHECK(version_with("classification", 300) == std::pair{2, 0});  // as an extra dimension
  CHECK(version_with("red", 65535) == std::pair{2, 2});
  CHECK(version_with("nir", 5) == std::pair{4, 8});
}

TEST_CASE("las__header_says_the_exact_bounds_and_counts_by_return") {
  const Folder folder;
  Cloud cloud = random_points(1000, 7);
  std::vector<uint8_t> returns(1000);
  for (size_t i = 0; i < 1000; ++i) returns[i] = static_cast<uint8_t>(1 + i % 3);
  cloud.fields.set(make_column<uint8_t>({"return_number"}, returns));
  write(cloud, folder.file("a.las"));
  const std::string bytes = slurp(folder.file("a.las"));
  const Cloud back = read(folder.file("a.las"));
  Task task;
  const Box3 box = bounds(back, task);
  for (int k = 0; k < 3; ++k) {
    CHECK(load<double>(bytes.data() + 179 + 16 * k) == box.max[k]);
    CHECK(load<double>(bytes.data() + 187 + 16 * k) == box.min[k]);
    CHECK(load<double>(bytes.data() + 155 + 8 * k) ==
          std::floor(load<double>(bytes.data() + 155 + 8 * k)));
  }
  CHECK(load<uint32_t>(bytes.data() + 111) == 334);
  CHECK(load<uint32_t>(bytes.data() + 115) == 333);
}

TEST_CASE("las__refuses_a_scale_that_does_not_hold_the_coordinates") {
  const Folder folder;
  WriteSettings settings;
  settings.scale = 1e-9;
  const Cloud cloud = random_points(10, 3);
  CHECK(failure_of([&] { write(cloud, folder.file("a.las"), settings); }).status == Status::kLimit);
  CHECK(folder.entries() == 0);
  Buffer<double> far(6);
  for (size_t i = 0; i < 6; ++i) far[i] = i < 3 ? -4e8 : 4e8;
  write(make_cloud(std::move(far)), folder.file("b.las"));  // takes a larger step by itself
  CHECK(read(folder.file("b.las")).point(1).x == doctest::Approx(4e8).epsilon(1e-9));
}

TEST_CASE("las__geographic_coordinates_and_contradicting_units_are_refused") {
  const Folder folder;
  Cloud cloud = random_points(5, 4, {2, 48, 0});
  cloud.crs = "EPSG:4326";
  CHECK(failure_of([&] { write(cloud, folder.file("a.las")); }).status == Status::kUnsupported);
  cloud.crs = "GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925]]";
  CHECK(failure_of([&] { write(cloud, folder.file("a.las")); }).status == Status::kUnsupported);
}

TEST_CASE("las__undescribed_extra_bytes_come_back_as_they_were") {
  const Folder folder;
  std::string bytes = header_of_points(0, 25, 2);
  for (int i = 0; i < 50; ++i) bytes += static_cast<char>(i % 25 < 20 ? 0 : i);
  spill(folder.file("a.las"), bytes);
  const Cloud cloud = read(folder.file("a.las"));
  CHECK(cloud.fields.require("extra_bytes").info().components == 5);
  write(cloud, folder.file("b.las"));
  CHECK(slurp(folder.file("b.las")).substr(227) == bytes.substr(227));
}

TEST_CASE("las__a_lying_count_is_refused_before_anything_is_allocated") {
  const Folder folder;
  std::string bytes = header_of_points(0, 20, 0xFFFFFFFF) + std::string(40, '\0');
  spill(folder.file("a.las"), bytes);
  const Failure failure = failure_of([&] { read(folder.file("a.las")); });
  CHECK(failure.status == Status::kFormat);
  CHECK(failure.text == folder.file("a.las") +
                            ": offset 227: the header promises 4294967295 points of 20 bytes, the "
                            "file ends after 2 whole ones");
}

TEST_CASE("las__coordinates_that_overflow_are_refused_or_dropped") {
  const Folder folder;
  std::string bytes = header_of_points(0, 20, 2) + std::string(40, '\0');
  store<double>(bytes.data() + 131, 1e308);
  store<int32_t>(bytes.data() + 227, 1000);
  spill(folder.file("a.las"), bytes);
  CHECK(failure_of([&] { read(folder.file("a.las")); }).text.find("point 0 ") != std::string::npos);
  ReadSettings settings;
  settings.drop_invalid = true;
  CHECK(read(folder.file("a.las"), settings).size() == 1);
}
