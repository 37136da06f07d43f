// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What a text file's columns are and where its points begin: against texts that were put together from known cells.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/layout.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

TextLayout layout_of(const std::string& text, const std::string& option = "") {
  const OpenedFile file(text, "a.txt");
  return detect_text_layout(file, option);
}

Failure refused_layout(const std::string& text, const std::string& option = "") {
  return failure_of([&] { layout_of(text, option); });
}

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names)
    out += (out.empty() ? "" : " ") + (name.empty() ? "_" : name);
  return out;
}

}  // namespace

TEST_CASE("text_layout__cells_come_back_from_the_line_they_were_joined_to") {
  RandomStream random(6, 3);
  const char* samples[] = {"", "a", "1.5", "-2e3", "two words", "\xC3\xA9"};
  for (int round = 0; round < 300; ++round)
    for (const char separator : {';', ',', ' '}) {
      std::vector<std::string> cells;
      std::string line;
      for (uint64_t i = 2 + random.below(6); i > 0; --i) {
        // Between blanks no cell is empty or has a blank.
        cells.push_back(samples[separator == ' ' ? 1 + random.below(3) : random.below(6)]);
        const bool quoted = separator != ' ' && random.below(3) == 0;
        if (cells.size() > 1)
          line +=
              separator == ' ' ? (random.below(2) == 0 ? " \t" : " ") : std::string(1, separator);
        line += quoted ? " \"" + cells.back() + "\"\t" : cells.back();
      }
      const auto found = cells_of(line, separator);
      REQUIRE(found.size() == cells.size());
      for (size_t i = 0; i < cells.size(); ++i) CHECK(found[i] == cells[i]);
    }
  CHECK(cells_of("", ';').empty());
  CHECK(cells_of(" \t", ' ').empty());
  for (const char* comment : {"", " \t\r", "# 1 2 3", "  // x", "%x"}) CHECK(is_comment(comment));
  for (const char* data : {"/ 1", "1 # 2", "-1 2 3", "x y z"}) CHECK_FALSE(is_comment(data));
  for (const char* count : {"0", " 7\t\r", "123456789012345678901234567890"})
    CHECK(is_count_line(count));
  for (const char* line : {"", "-1", "1.5", "1e3", "1,2", "1;2;3", "1;", "1 2", "one", "1x", "#1"})
    CHECK_FALSE(is_count_line(line));
}

TEST_CASE("text_layout__data_begin_at_the_first_line_of_numbers_whatever_stands_before") {
  const std::string data = "1;2;3;4\n5;6;7;8\n";
  for (const std::string mark : {"", "\xEF\xBB\xBF"})
    for (const std::string comment : {"", "# crs: EPSG:2154\n\n// said\n"})
      for (const std::string count : {"", "2\n"})
        for (const std::string header : {"", "Y;\"X\";Z;t\r\n"}) {
          const std::string before = mark + comment + count + header;
          CAPTURE(before);
          const TextLayout layout = layout_of(before + data);
          // The first line may begin behind the mark of UTF-8.
          CHECK(layout.data_offset == before.size());
          CHECK(layout.data_line ==
                1 + static_cast<uint64_t>(std::count(before.begin(), before.end(), '\n')));
          CHECK(layout.separator == ';');
          CHECK(layout.count_lines == !count.empty());
          CHECK(layout.crs == (comment.empty() ? "" : "EPSG:2154"));
          CHECK(joined(layout.names) == (header.empty() ? "x y z intensity" : "y x z t"));
        }
}

TEST_CASE("text_layout__decimal_commas_are_seen_by_the_points_that_are_not_there") {
  CHECK(layout_of("1,5;2,5;3\n").decimal_comma);
  CHECK(layout_of("1,5\t2,5\t3\n").decimal_comma);
  CHECK(layout_of("1,5\t2,5\t3\n").separator == ' ');
  CHECK_FALSE(layout_of("1.5;2;3\n").decimal_comma);
  CHECK_FALSE(layout_of("1;2,500;3.5\n").decimal_comma);
  const TextLayout table = layout_of("1,5,2,5\n");
  CHECK(table.separator == ',');
  CHECK(table.names.size() == 4);
  CHECK_FALSE(table.decimal_comma);
}

TEST_CASE("text_layout__names_are_the_usual_ones_each_once_and_the_option_goes_first") {
  CHECK(joined(layout_of("X Y Z I NormalX normal_y NZ GpsTime\n1 2 3 4 5 6 7 8\n").names) ==
        "x y z intensity nx ny nz gps_time");
  CHECK(joined(layout_of("x y z R G B\n1 2 3 4 5 6\n").names) == "x y z red green blue");
  CHECK(joined(layout_of("x y z r g q\n1 2 3 4 5 6\n").names) == "x y z r g q");  // no colour alone
  CHECK(joined(layout_of("E N H e\n1 2 3 4\n", "x y z").names) == "x y z _");
  CHECK(joined(layout_of("x y z a a - a\n1 2 3 4 5 6 7\n").names) == "x y z a a_2 _ a_3");
  CHECK(joined(layout_of("x y z a\n1 2 3 4\n", "-, y;x\tz").names) == "_ y x z");
  CHECK(joined(layout_of("x y z normal nx ny nz\n1 2 3 4 5 6 7\n").names) ==
        "x y z normal_2 nx ny nz");  // the three become a field of this name
  CHECK(joined(layout_of("x y z normal nx ny\n1 2 3 4 5 6\n").names) == "x y z normal nx ny");
  CHECK(usual_name("INTENSITY") == "intensity");
  CHECK(usual_name("Own") == "Own");
  const std::string six = "1 2 3 0 0 1\n", third = "4 5 6 9 0 0\n", fourth = "4 5 6 256 0 0\n";
  CHECK(joined(layout_of(six).names) ==
        "x y z red green blue");  // a normal as well: colours go first
  CHECK(joined(layout_of(six + third).names) == "x y z red green blue");  // every line is asked
  CHECK(joined(layout_of(six + "1 2 3 0 0.6 0.8\n").names) == "x y z nx ny nz");
  CHECK(joined(layout_of(six + fourth).names) == "x y z column_4 column_5 column_6");
  // Of nine columns the other three tell what zeros and ones are; nobody writes the same three twice.
  CHECK(joined(layout_of("1 2 3 0 0 1 7 8 9\n").names) == "x y z nx ny nz red green blue");
  CHECK(joined(layout_of("1 2 3 7 8 9 0 0 1\n").names) == "x y z red green blue nx ny nz");
  CHECK(joined(layout_of("1 2 3 7 8 9 4 5 6\n").names) ==
        "x y z red green blue column_7 column_8 column_9");
}

TEST_CASE("text_layout__files_that_cannot_be_laid_out_are_refused_with_line_and_column") {
  const auto says = [](const Failure& failure, const std::string& words) {
    CHECK(failure.status == Status::kFormat);
    CHECK_MESSAGE(has_text(failure.text, words), failure.text);
  };
  says(refused_layout("1 2\n"), "a.txt: line 1, column 1: a point needs three coordinates");
  says(refused_layout("1.5\n1 2 3\n"), "line 1, column 1: a point needs three coordinates");
  says(refused_layout("x y z t\n# c\n1 2 3\n"), "line 3, column 3: the header has another number");
  says(refused_layout("a b c\nd e f\n"), "line 2, column 1: this is no number");
  says(refused_layout("# a\n# b\n"), "line 2, column 1: there is no line of numbers");
  says(refused_layout("1 2 3\n", "x y z a"),
       "line 1, column 3: the line has 3 columns, 4 were named");
  says(refused_layout(std::string("\xFF\xFE") + "1"), "UTF-16");
  says(refused_layout(std::string((size_t{1} << 20) + 1, '1')), "the first line is longer than");
  std::string wide;
  for (int i = 0; i < 4097; ++i) wide += "1 ";
  says(refused_layout(wide), "more columns than the 4096");
  const Failure option = refused_layout("1 2 3\n", "x x z");
  CHECK(option.status == Status::kInvalidArgument);
  CHECK(has_text(option.text, "\"x x z\""));
}
