// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Points and fields out of lines of numbers: types by the values that stand there, cells in all spellings.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "formats/text/text.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud text_cloud(const std::string& text, const ReadSettings& settings = {}) {
  const OpenedFile file(text, "a.txt");
  Task task;
  return read_text(file, settings, task);
}

std::string refused_points(const std::string& text) {
  const Failure failure = failure_of([&] { text_cloud(text); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

// The type of a column of this name with these two values.
std::string type_with(const std::string& name, const std::string& a, const std::string& b) {
  const Cloud cloud = text_cloud("x y z " + name + "\n0 0 0 " + a + "\n1 1 1 " + b + "\n");
  return name_of(cloud.fields.require(name).info().type);
}

}  // namespace

TEST_CASE("text_reader__the_type_is_the_smallest_usual_one_that_holds_every_value") {
  CHECK(type_with("own", "0", "2147483647") == "int32");
  CHECK(type_with("own", "-2147483648", "1") == "int32");
  CHECK(type_with("own", "0", "2147483648") == "uint32");
  CHECK(type_with("own", "0", "4294967295") == "uint32");
  CHECK(type_with("own", "-1", "2147483648") == "int64");
  CHECK(type_with("own", "0", "4294967296") == "int64");
  CHECK(type_with("own", "1", "9223372036854775807") == "int64");
  CHECK(type_with("own", "1", "9223372036854775808") == "uint64");
  CHECK(type_with("own", "-1", "9223372036854775808") == "float64");  // no integer holds both
  CHECK(type_with("own", "1", "18446744073709551616") == "float64");
  CHECK(type_with("own", "1", "2.0") == "float64");  // written with a point
  CHECK(type_with("own", "1", "2e0") == "float64");
  CHECK(type_with("classification", "0", "255") == "uint8");
  CHECK(type_with("classification", "0", "256") == "int32");
  CHECK(type_with("classification", "-1", "0") == "int32");
  CHECK(type_with("intensity", "0", "65535") == "uint16");
  CHECK(type_with("intensity", "0", "65536") == "int32");
  CHECK(type_with("red", "0", "255") == "uint8");
  CHECK(type_with("red", "0", "256") == "uint16");
  CHECK(type_with("gps_time", "1", "2") == "float64");
}

TEST_CASE("text_reader__the_same_points_come_out_of_every_spelling_of_their_cells") {
  const std::string header = "x;y;z;a\n";
  const Cloud wanted = text_cloud(header + "1.5;-2;3000;4\n-0.25;5;6;9007199254740993\n");
  CHECK(wanted.point(0) == Vec3{1.5, -2, 3000});
  CHECK(wanted.point(1) == Vec3{-0.25, 5, 6});
  CHECK(wanted.fields.require("a").values<int64_t>()[1] == 9007199254740993);  // no double holds it
  for (const std::string lines : {
           "1,5;-2;3000;4\n-0,25;5;6;9007199254740993\n",
           "\"1.5\";\"-2\";\"3e3\";\"4\"\r\n\"-.25\";\"5\";\"6\";\"9007199254740993\"\r\n",
           " +1.50 ;\t-2.0; +3000.;+4\n# said\n\n-25e-2;+5;0006;+9007199254740993",
       }) {
    CAPTURE(lines);
    const Cloud cloud = text_cloud(header + lines);
    REQUIRE(cloud.size() == 2);
    CHECK(cloud.point(0) == wanted.point(0));
    CHECK(cloud.point(1) == wanted.point(1));
    const auto a = cloud.fields.require("a").values<int64_t>();
    CHECK(a[0] == 4);
    CHECK(a[1] == 9007199254740993);
  }
}

TEST_CASE(
    "text_reader__empty_cells_are_nan_skipped_columns_may_hold_words_and_counts_are_no_points") {
  const Cloud gaps = text_cloud("x,y,z,a,b\n1,2,3,,5\n4,5,6,7,\n");
  CHECK(std::isnan(gaps.fields.require("a").number(0)));
  CHECK(gaps.fields.require("a").number(1) == 7);
  CHECK(std::isnan(gaps.fields.require("b").number(1)));
  ReadSettings settings;
  settings.columns = "_ x y z - a";
  const Cloud named = text_cloud("1 1 2 3 wall 5\n2 4 5 6 1e5x 7\n", settings);
  CHECK(named.point(1) == Vec3{4, 5, 6});
  CHECK(named.fields.size() == 1);
  CHECK(named.fields.require("a").number(1) == 7);
  CHECK(text_cloud("2\n1 2 3\n4 5 6\n 1 \n7 8 9\n").size() == 3);
  CHECK(has_text(refused_points("1 2 3\n1\n"), "line 2, column 2"));  // no count line at the top
  settings.columns = "";
  settings.drop_invalid = true;
  const Cloud kept = text_cloud("x,y,z\n1,2,3\n,2,3\n4,5,6\n", settings);
  CHECK(kept.size() == 2);
  CHECK(kept.point(1) == Vec3{4, 5, 6});
}

TEST_CASE("text_reader__after_a_count_no_line_is_passed_over_but_whole_numbers_alone") {
  for (const char* separator : {" ", "\t", ";", ",", " ; "}) {
    CAPTURE(separator);
    const std::string s = separator, lines = "1" + s + "2" + s + "3\n4" + s + "5" + s + "6\n";
    const Cloud cloud = text_cloud("2\n" + lines + " 1\r\n7" + s + "8" + s + "9\n");
    REQUIRE(cloud.size() == 3);
    CHECK(cloud.point(1) == Vec3{4, 5, 6});
    CHECK(cloud.point(2) == Vec3{7, 8, 9});
    for (const char* wrong : {"garbage", "1.5", "-1", "1x"})
      CHECK(has_text(refused_points("2\n" + lines + wrong + "\n" + lines), "line 4, column "));
  }
  CHECK(text_cloud("2\n1,5;2;3\n4;5,5;6\n").point(1) == Vec3{4, 5.5, 6});
}

TEST_CASE("text_reader__a_line_that_is_wrong_is_named_after_all_that_is_passed_over") {
  std::string before = "x y z a\n1 2 3 4\n";
  for (int i = 0; i < 20000; ++i)
    before += i % 3 == 0 ? "# nothing\n" : "1 2 3 4\n";  // 20002 lines
  const auto wrong = [&](const std::string& line) { return refused_points(before + line); };
  CHECK(has_text(wrong("1 2 3 4x\n"), "a.txt: line 20003, column 4: this is no number"));
  CHECK(has_text(wrong("\n1 2 3"), "line 20004, column 4: the line has fewer columns"));
  CHECK(has_text(wrong("1 2 3 4 5\n"), "line 20003, column 5: the line has more columns"));
  CHECK(has_text(wrong("1 2 --3 4\n"), "line 20003, column 3: this is no number"));
  CHECK(has_text(refused_points("1;2;3;4\n1;2;3;4;\n"), "line 2, column 5: the line has more"));
  CHECK(has_text(refused_points("1;2;3;4\n1;2;3\n"), "line 2, column 4: the line has fewer"));
  CHECK(has_text(refused_points("1;2;3;4\n1;2 3;4;5\n"), "line 2, column 2: this is no number"));
}

TEST_CASE("text_reader__pieces_have_the_points_and_types_of_the_whole") {
  // Blocks of a mebibyte: three of them; types that the last line alone decides, and a wide one.
  std::string text = "# x y z whole late wide nx ny nz\n";
  constexpr size_t kLines = 60000;
  for (size_t i = 0; i < kLines; ++i) {
    const std::string number = std::to_string(i);
    text += "652000." + number + " 6861000 -" + number + ".5 " + number + " " + number +
            (i + 1 == kLines ? ".5 " : " ") + std::to_string((1ull << 60) + i) + " 0 0 1\n";
    if (i % 1000 == 0) text += "# a comment\n\n";
  }
  const OpenedFile file(text, "a.txt");
  Task task;
  const Cloud whole = read_text(file, {}, task);
  const auto pieces = pieces_of_text(file, "", task);
  CHECK(pieces->count() == kLines);
  REQUIRE(pieces->look_through(task));
  for (int pass = 0; pass < 2; ++pass, pieces->rewind()) {
    size_t at = 0, count = 0;
    for (Cloud piece; pieces->next(1000, piece, task); ++count) {
      REQUIRE(at + piece.size() <= kLines);
      CHECK(std::ranges::equal(piece.xyz(), whole.xyz().subspan(3 * at, 3 * piece.size())));
      for (const ColumnPtr& column : whole.fields) {
        const Column& found = piece.fields.require(column->info().name);
        CHECK(found.info().type == column->info().type);
        const size_t bytes = size_of(column->info().type) * column->info().components;
        CHECK(std::memcmp(found.raw(), static_cast<const char*>(column->raw()) + at * bytes,
                          piece.size() * bytes) == 0);
      }
      at += piece.size();
    }
    CHECK(at == kLines);
    CHECK(count > 2);
  }
}

TEST_CASE("text_reader__pieces_are_none_where_a_coordinate_is_not_finite") {
  const OpenedFile file("1 2 3\nnan 2 3\n", "a.txt");
  Task task;
  CHECK(!pieces_of_text(file, "", task)->look_through(task));
}

TEST_CASE("text_reader__a_small_file_is_read_whole") {
  const OpenedFile file("1 2 3\n", "a.txt");
  Task task;
  CHECK(text_pieces(file, {}, task) == nullptr);
}
