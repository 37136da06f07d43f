// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>

#include "formats/files/fast_number.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string names_of(const Cloud& cloud) {
  std::string names;
  for (const ColumnPtr& column : cloud.fields)
    names += (names.empty() ? "" : " ") + column->info().name;
  return names;
}

}  // namespace

TEST_CASE("text__numbers_are_correctly_rounded") {
  RandomStream random(1, 1);
  for (int i = 0; i < 200000; ++i) {
    char text[64];
    const double value = std::bit_cast<double>(random.bits());
    const double divisor = std::pow(10, static_cast<double>(random.below(12)));
    const double shorter =
        static_cast<double>(static_cast<int64_t>(random.bits() >> (11 + random.below(50)))) /
        divisor;
    for (const double wanted : {value, shorter}) {
      if (!std::isfinite(wanted)) continue;
      const auto end = std::to_chars(text, text + sizeof text, wanted).ptr;
      ParsedNumber number;
      REQUIRE(parse_number_at(text, end, number) == end);
      REQUIRE(number.value == wanted);
    }
  }
}

TEST_CASE("text__columns_without_names_are_guessed_in_both_orders") {
  CHECK(names_of(read_as_text("1 2 3\n4 5 6\n")) == "");
  CHECK(names_of(read_as_text("1 2 3 7.5\n")) == "intensity");
  CHECK(names_of(read_as_text("1 2 3 255 0 17\n")) == "red green blue");
  CHECK(names_of(read_as_text("1 2 3 0.6 0 0.8\n")) == "normal");
  CHECK(names_of(read_as_text("1 2 3 0.6 0 8\n")) == "column_4 column_5 column_6");
  CHECK(names_of(read_as_text("1 2 3 900 10 20 30\n")) == "intensity red green blue");
  // x y z i nx ny nz r g b, and the order of the printed example: x y z i r g b nx ny nz.
  CHECK(names_of(read_as_text("1 2 3 900 0.6 0 0.8 10 20 30\n")) ==
        "intensity red green blue normal");
  CHECK(names_of(read_as_text("1 2 3 900 10 20 30 0.6 0 0.8\n")) ==
        "intensity red green blue normal");
  const Cloud axis =
      read_as_text("1 2 3 900 10 20 30 0 0 1\n");  // both readings are possible for the last three
  CHECK(axis.fields.require("normal").number(0, 2) == 1);
  CHECK(axis.fields.require("red").number(0) == 10);
  const Cloud other = read_as_text("1 2 3 900 0 0 1 10 20 30\n");
  CHECK(other.fields.require("normal").number(0, 2) == 1);
  CHECK(other.fields.require("red").number(0) == 10);
}

TEST_CASE("text__the_columns_option_names_and_skips") {
  const Cloud cloud = read_as_text("9 1 2 3 0.5 44\n8 4 5 6 0.25 45\n", "- x y z _ class");
  CHECK(cloud.size() == 2);
  CHECK(cloud.point(1) == Vec3{4, 5, 6});
  CHECK(names_of(cloud) == "class");
  CHECK(cloud.fields.require("class").info().type == ElementType::kInt32);
  CHECK(failure_of([] { read_as_text("1 2 3\n", "x y z i"); }).status == Status::kFormat);
  CHECK(failure_of([] { read_as_text("1 2 3\n", "x y w"); }).status == Status::kInvalidArgument);
}

TEST_CASE("text__headers_comments_separators_and_decimal_commas") {
  CHECK(names_of(read_as_text("# x y z intensity class instance\n1 2 3 4 5 6\n")) ==
        "intensity class instance");
  CHECK(names_of(read_as_text("//X Y Z R G B\n1 2 3 4 5 6\n")) == "red green blue");
  CHECK(names_of(read_as_text("X;Y;Z;\"Label a\"\r\n1;2;3;4\r\n")) == "Label a");
  CHECK(names_of(read_as_text("\xEF\xBB\xBFx,y,z,t\n1,2,3,4\n\n# end\n")) == "t");
  const Cloud comma = read_as_text("652000,25;6861000,5;-0,125\n1,0;2,0;3,0\n");
  CHECK(comma.point(0) == Vec3{652000.25, 6861000.5, -0.125});
  const Cloud swapped = read_as_text("northing,easting,height\n6861000,652000,100\n");
  CHECK(swapped.point(0) == Vec3{652000, 6861000, 100});
  CHECK(read_as_text("2\n1 2 3 4\n5 6 7 8\n").size() == 2);              // PTS
  CHECK(read_as_text("2\n1 2 3 4\n5 6 7 8\n1\n9 9 9 9\n").size() == 3);  // two scans
  const Cloud empty_cell = read_as_text("x,y,z,t\n1,2,3,\n4,5,6,7\n");
  CHECK(std::isnan(empty_cell.fields.require("t").number(0)));
}

TEST_CASE("text__errors_name_line_and_column") {
  const auto text_of_failure = [](const std::string& text) {
    return failure_of([&] { read_as_text(text); }).text;
  };
  CHECK(text_of_failure("1 2 3\n4 x 6\n").find("line 2, column 2: this is no number") !=
        std::string::npos);
  CHECK(
      text_of_failure("# c\n1 2 3\n\n4 5\n").find("line 4, column 3: the line has fewer columns") !=
      std::string::npos);
  CHECK(text_of_failure("1 2 3\n4 5 6 7\n").find("line 2, column 4: the line has more columns") !=
        std::string::npos);
  CHECK(text_of_failure("1;2;3\n4;5;6;\n").find("line 2, column 4") != std::string::npos);
  CHECK(text_of_failure("hello world\nfoo\n").find("line 2, column 1") != std::string::npos);
  CHECK(text_of_failure("\n\n").find("no line of numbers") != std::string::npos);
  CHECK(text_of_failure("1 2\n").find("three coordinates") != std::string::npos);
  CHECK(failure_of([] { read_as_text("1 2 nan\n"); }).text.find("point 0") != std::string::npos);
}

TEST_CASE("text__integers_of_64_bits_survive") {
  const Cloud cloud = read_as_text(
      "x y z a b c\n0 0 0 9223372036854775807 18446744073709551615 -9007199254740993\n1 1 1 1 2 "
      "3\n");
  CHECK(cloud.fields.require("a").values<int64_t>()[0] == 9223372036854775807);
  CHECK(cloud.fields.require("b").values<uint64_t>()[0] == 18446744073709551615ull);
  CHECK(cloud.fields.require("c").values<int64_t>()[0] == -9007199254740993);
}

TEST_CASE("text__round_trip_keeps_random_fields_of_every_type_and_coordinates_exactly") {
  const Folder folder;
  size_t columns = 0;
  for (uint64_t seed = 1; seed < 30; ++seed) {
    RandomStream random(seed, 5);
    const size_t n = 1 + random.below(2000);
    Cloud cloud = random_points(n, seed);
    cloud.crs = seed % 2 == 0 ? "EPSG:2154" : "";
    for (int32_t type = 1; type <= 10; ++type)
      cloud.fields.set(random_column(std::to_string(type).insert(0, 1, 'f'),
                                     static_cast<ElementType>(type), 1, n, random));
    cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, n, random));
    const std::string path = folder.file(seed % 3 == 0 ? "a.csv" : "a.xyz");
    write(cloud, path);
    const Cloud back = read(path);
    REQUIRE(back.size() == n);
    for (size_t i = 0; i < 3 * n; ++i) REQUIRE(back.xyz()[i] == cloud.xyz()[i]);
    for (const ColumnPtr& column : cloud.fields) {
      CHECK_MESSAGE(same_values(*column, back.fields.require(column->info().name)), "seed ", seed,
                    " ", column->info().name);
      ++columns;
    }
    if (seed % 3 != 0) CHECK(back.crs.str() == cloud.crs.str());
  }
  MESSAGE("columns compared: ", columns);
}

TEST_CASE("text__blocks_cut_anywhere_give_the_same_points_for_any_number_of_threads") {
  const Folder folder;
  std::string text;
  RandomStream random(3, 3);
  std::vector<double> wanted;
  for (int i = 0; i < 120000; ++i) {  // several blocks of 1 MiB
    if (random.below(50) == 0) text += "# a comment line\n\n";
    for (int k = 0; k < 3; ++k) {
      const double value = std::round(random.normal() * 1e6) / 1000;
      char number[32];
      text.append(number, std::to_chars(number, number + sizeof number, value).ptr) +=
          k == 2 ? '\n' : ' ';
      wanted.push_back(value);
    }
  }
  spill(folder.file("a.xyz"), text);
  for (const unsigned threads : {1u, 2u, 7u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    const Cloud cloud = read_cloud(folder.file("a.xyz"), {}, task);
    REQUIRE(cloud.size() == 120000);
    CHECK(std::equal(wanted.begin(), wanted.end(), cloud.xyz().begin()));
  }
  spill(folder.file("b.xyz"), text + "1 2 x\n");
  size_t lines = static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  CHECK(failure_of([&] {
          read(folder.file("b.xyz"));
        }).text.find(std::to_string(lines + 1).append(", column 3")) != std::string::npos);
}

TEST_CASE("text__street_files_have_their_labels") {
  for (const auto& [name, points] :
       {std::pair{"facades/street_1.txt", 54864}, std::pair{"facades/street_3.txt", 39960}}) {
    const std::string path = shared(name);
    if (path.empty()) return;
    const Cloud cloud = read(path);
    CHECK(cloud.size() == static_cast<size_t>(points));
    CHECK(names_of(cloud) == "intensity class instance");
    CHECK(cloud.fields.require("intensity").info().type == ElementType::kUint16);
    size_t wall = 0;
    for (size_t i = 0; i < cloud.size(); ++i)
      wall += cloud.fields.require("class").number(i) == 1 ? 1 : 0;
    MESSAGE(std::string(name), ": ", cloud.size(), " points, ", wall, " of class wall");
  }
}

TEST_CASE("text__hostile_field_names_stay_in_their_cell") {
  const Folder folder;
  Cloud cloud = random_points(2, 1);
  const double values[] = {1, 2};
  const char* hostile[] = {"=1+1", "@x",  "a,b", "a;b", "a b",  "a\nb", "\"q\"",
                           "#c",   "//c", "-",   "3",   "x\ty", "\x01", "é"};
  for (const char* name : hostile) cloud.fields.set(make_column<double>({name}, values));
  for (const char* file : {"a.csv", "a.txt"}) {
    write(cloud, folder.file(file));
    const Cloud back = read(folder.file(file));
    CHECK(back.size() == 2);
    CHECK(back.fields.size() == std::size(hostile));
  }
  CHECK(slurp(folder.file("a.csv")).find(",=") == std::string::npos);
}
