// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/step_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::ifc;
using namespace jalon::test;

TEST_CASE("step_file__numbers_have_a_point_and_read_back_the_same") {
  CHECK(real_text(1) == "1.");
  CHECK(real_text(-0.0) == "0.");
  CHECK(real_text(2.5) == "2.5");
  CHECK(real_text(1e-7) == "1.E-07");
  CHECK(real_text(652417.123456) == "652417.123456");
  CHECK(std::stod(real_text(0.1 + 0.2)) == 0.1 + 0.2);
  CHECK(Values().real(std::numeric_limits<double>::quiet_NaN()).str() == "$");
}

TEST_CASE("step_file__texts_escape_quotes_and_all_that_is_no_printable_ascii") {
  CHECK(string_text("wall") == "'wall'");
  CHECK(string_text("l'\\") == "'l''\\\\'");
  CHECK(string_text("\xC3\xA9t\xC3\xA9") == "'\\X2\\00E9\\X0\\t\\X2\\00E9\\X0\\'");
  CHECK(string_text("\xF0\x9F\x8F\xA0") == "'\\X4\\0001F3E0\\X0\\'");
  CHECK(string_text("a\nb") == "'a\\X2\\000A\\X0\\b'");
  CHECK(string_text("\xFF") == "'\\X2\\FFFD\\X0\\'");
}

TEST_CASE("step_file__values_stand_in_lists_and_entities_are_numbered") {
  CHECK(Values().id(3).none().list(Values().integer(1).integer(2)).word("X").flag(true).str() ==
        "#3,$,(1,2),.X.,.T.");
  CHECK(Values().id(0).point({1, 2, 3.5}).typed("IFCLABEL", Values().text("a")).str() ==
        "$,(1.,2.,3.5),IFCLABEL('a')");
  const Folder folder;
  {
    AtomicFile file(folder.file("a.ifc"));
    StepFile step(file, "V", "n");
    CHECK(step.add("IFCX", Values().integer(1)) == 1);
    CHECK(step.add("IFCY", Values().id(1)) == 2);
    step.end();
    file.commit();
  }
  const std::string text = slurp(folder.file("a.ifc"));
  CHECK(text.starts_with("ISO-10303-21;\n"));
  CHECK(text.find("#1=IFCX(1);\n#2=IFCY(#1);\nENDSEC;\nEND-ISO-10303-21;\n") != std::string::npos);
}

TEST_CASE("step_file__identifiers_are_22_characters_that_names_alone_decide") {
  std::set<std::string> seen;
  for (int i = 0; i < 20000; ++i) {
    const std::string id = guid_of("wall/" + std::to_string(i));
    REQUIRE(id.size() == 22);
    REQUIRE(id[0] <= '3');  // 128 bits, six a character: two are left for the first
    seen.insert(id);
  }
  CHECK(seen.size() == 20000);
  CHECK(guid_of("a") == guid_of("a"));
}
