// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Written text files as a spreadsheet or a script reads them: a header, and a cell a number.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "formats/text/text.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string text_of_cloud(const Cloud& cloud, bool csv, int decimals = -1) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.decimals = decimals;
  if (csv) write_csv(cloud, folder.file("a"), settings, task);
  else write_text(cloud, folder.file("a"), settings, task);
  return slurp(folder.file("a"));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);) out.push_back(piece);
  return out;
}

Cloud one_point(double x, double y, double z) {
  Buffer<double> xyz(3);
  xyz[0] = x;
  xyz[1] = y;
  xyz[2] = z;
  return make_cloud(std::move(xyz));
}

template <class T>
void add_value(Cloud& cloud, const std::string& name, T value) {
  const T values[] = {value};
  cloud.fields.set(make_column<T>({name}, values));
}

}  // namespace

TEST_CASE("text_writer__every_line_has_a_cell_for_each_name_of_the_header") {
  Cloud cloud = random_points(50, 9);
  RandomStream random(4, 4);
  cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, 50, random));
  cloud.fields.set(random_column("pair", ElementType::kUint8, 2, 50, random));
  cloud.fields.set(random_column("normal of two", ElementType::kInt64, 2, 50, random));
  cloud.fields.set(random_column("time", ElementType::kFloat64, 1, 50, random));
  const std::string names = "x,y,z,nx,ny,nz,pair_0,pair_1,normal_of_two_0,normal_of_two_1,time";
  for (const bool csv : {false, true}) {
    const std::vector<std::string> lines = split(text_of_cloud(cloud, csv), '\n');
    REQUIRE(lines.size() == 51);
    std::string header = names;
    if (!csv) std::replace(header.begin(), header.end(), ',', ' ');
    CHECK(lines[0] == (csv ? "" : "# ") + header);
    for (size_t i = 0; i < 50; ++i) {
      const std::vector<std::string> cells = split(lines[i + 1], csv ? ',' : ' ');
      REQUIRE(cells.size() == 11);
      CHECK(std::stod(cells[1]) == cloud.point(i).y);
      CHECK(std::stof(cells[5]) == cloud.fields.require("normal").values<float>()[3 * i + 2]);
      CHECK(std::stoi(cells[7]) == cloud.fields.require("pair").values<uint8_t>()[2 * i + 1]);
      CHECK(std::stoll(cells[8]) == cloud.fields.require("normal of two").values<int64_t>()[2 * i]);
      CHECK(std::stod(cells[10]) == cloud.fields.require("time").values<double>()[i]);
    }
  }
}

TEST_CASE("text_writer__decimals_round_the_coordinates_alone") {
  Cloud cloud = one_point(652000.12649, -0.0004, 2e14);
  add_value(cloud, "a", 1.0 / 3);
  add_value(cloud, "b", std::numeric_limits<float>::quiet_NaN());
  add_value(cloud, "c", std::numeric_limits<int8_t>::min());
  CHECK(split(text_of_cloud(cloud, true, 3), '\n')[1] ==
        "652000.126,0.000,200000000000000.000,0.3333333333333333,nan,-128");
  CHECK(split(text_of_cloud(cloud, true, 0), '\n')[1].starts_with("652000,0,200000000000000,"));
  const Cloud many = random_points(200, 6, {0, 0, 0});
  for (const int decimals : {0, 1, 4, 7}) {
    const std::vector<std::string> lines = split(text_of_cloud(many, true, decimals), '\n');
    for (size_t i = 0; i < 200; ++i) {
      const std::string cell = split(lines[i + 1], ',')[0];
      // Half of the last decimal, and a step of a double below 32.
      CHECK(std::fabs(std::stod(cell) - many.point(i).x) <=
            0.5 * std::pow(10.0, -decimals) + 0x1p-48);
      CHECK(split(cell + "..", '.')[1].size() == static_cast<size_t>(decimals));
    }
  }
}

TEST_CASE("text_writer__names_stay_one_cell_that_no_program_takes_for_a_formula_or_a_number") {
  const char* hostile[] = {"=1+1", "+a", "-a",          "@a",    "%a", ".5", "7",  "-",
                           "_",    " ",  "a,b;c\td\ne", "\"q\"", "'q", "#a", "/a", "\x7f"};
  Cloud cloud = one_point(1, 2, 3);
  for (const char* name : hostile) add_value(cloud, name, int32_t{4});
  for (const bool csv : {false, true}) {
    const std::vector<std::string> lines = split(text_of_cloud(cloud, csv), '\n');
    REQUIRE(lines.size() == 2);
    const std::vector<std::string> cells = split(lines[0].substr(csv ? 0 : 2), csv ? ',' : ' ');
    REQUIRE(cells.size() == 3 + std::size(hostile));
    for (size_t i = 3; i < cells.size(); ++i) {
      CAPTURE(cells[i]);
      CHECK(cells[i].find_first_of("=+-@%.0123456789#/\"'\t") != 0);
      CHECK(cells[i].find_first_of(",;\"' \t") == std::string::npos);
      CHECK(cells[i] != "_");  // a column that readers pass over
    }
  }
}

TEST_CASE("text_writer__fields_called_like_a_coordinate_or_like_others_have_names_of_their_own") {
  Cloud cloud = one_point(1, 2, 3);
  add_value(cloud, "x", int32_t{10});
  add_value(cloud, "Y", int32_t{11});
  add_value(cloud, "z[m]", int32_t{12});
  add_value(cloud, "x_2", int32_t{13});
  add_value(cloud, "nx", int32_t{14});
  const float normal[] = {0, 0.6f, 0.8f};
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3}, normal));
  add_value(cloud, "I", int32_t{15});
  add_value(cloud, "intensity", int32_t{16});
  add_value(cloud, "a b", int32_t{17});
  add_value(cloud, "a_b", int32_t{18});
  for (const bool csv : {false, true}) {
    const std::string text = text_of_cloud(cloud, csv);
    CHECK(split(text, '\n')[0] ==
          (csv ? "x,y,z,x_2,y_2,z_2,x_2_2,nx_2,nx,ny,nz,I,intensity_2,a_b,a_b_2"
               : "# x y z x_2 y_2 z_2 x_2_2 nx_2 nx ny nz I intensity_2 a_b a_b_2"));
    const OpenedFile file(text, "a.txt");
    Task task;
    const Cloud back = read_text(file, {}, task);
    REQUIRE(back.fields.size() == 10);
    CHECK(back.point(0) == Vec3{1, 2, 3});
    int32_t value = 10;
    for (const char* name :
         {"x_2", "y_2", "z_2", "x_2_2", "nx_2", "intensity", "intensity_2", "a_b", "a_b_2"})
      CHECK(back.fields.require(name).number(0) == value++);
    CHECK(back.fields.require("normal").number(0, 1) == doctest::Approx(0.6));
  }
}

TEST_CASE("text_writer__the_crs_stands_above_the_names_where_a_line_can_hold_it") {
  Cloud cloud = one_point(1, 2, 3);
  cloud.crs = "PROJCS[\"a b\"]";
  CHECK(text_of_cloud(cloud, false) == "# crs: PROJCS[\"a b\"]\n# x y z\n1 2 3\n");
  CHECK(text_of_cloud(cloud, true) == "x,y,z\n1,2,3\n");
  cloud.crs = "a\n9 9 9";
  CHECK(text_of_cloud(cloud, false) == "# x y z\n1 2 3\n");
}
