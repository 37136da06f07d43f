// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/frame.h"

#include <doctest/doctest.h>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::ifc;
using namespace jalon::test;

namespace {

std::string framed(const char* crs) {
  const Folder folder;
  Model model;
  model.crs = crs;
  {
    AtomicFile file(folder.file("a.ifc"));
    StepFile step(file, "V", "n");
    const Frame frame = add_frame(step, model, {652000, 6861000, -3});
    CHECK(frame.site > frame.body);
    step.end();
    file.commit();
  }
  return slurp(folder.file("a.ifc"));
}

}  // namespace

TEST_CASE("ifc_frame__a_crs_without_code_or_metres_leaves_the_place_to_the_site") {
  for (const char* crs : {"", "EPSG:4326", "LOCAL_CS[\"site\"]"}) {
    const std::string text = framed(crs);
    CHECK(text.find("IFCMAPCONVERSION") == std::string::npos);
    CHECK(text.find("((652000.,6861000.,-3.))") != std::string::npos);
  }
}

TEST_CASE("ifc_frame__a_code_makes_a_map_conversion_and_the_site_stands_at_its_origin") {
  const std::string text = framed("EPSG:2154");
  CHECK(text.find(",652000.,6861000.,-3.,1.,0.,1.)") != std::string::npos);
  CHECK(text.find("IFCCARTESIANPOINT((652000.") == std::string::npos);
}
