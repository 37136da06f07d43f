// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Files of other makers: counts, poses, colours, scaled integers; malformed ones.
#include <doctest/doctest.h>

#include "formats/codecs/codecs.h"
#include "formats/e57/e57.h"
#include "formats/files/endian.h"
#include "fuzz/e57_page.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// "" after saying why the test is skipped.
std::string e57_path(const std::string& name) {
  if (has_codecs()) return shared("e57/" + name);
  MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
  return "";
}

constexpr size_t kPhysicalPage = 1024, kLogicalPage = 1020;

/// The file with this text before the first such text of its XML.
std::string with_xml(const std::string& bytes, const std::string& before, const std::string& text) {
  const auto physical = load<uint64_t>(bytes.data() + 24);
  const size_t at = physical - 4 * (physical / kPhysicalPage);
  std::string logical;
  for (size_t page = 0; page < bytes.size() / kPhysicalPage; ++page)
    logical += bytes.substr(page * kPhysicalPage, kLogicalPage);
  std::string xml = logical.substr(at, load<uint64_t>(bytes.data() + 32));
  REQUIRE(xml.find(before) != std::string::npos);
  xml.insert(xml.find(before), text);
  logical.resize(at);
  logical += xml;
  logical.resize((logical.size() + kLogicalPage - 1) / kLogicalPage * kLogicalPage);
  store<uint64_t>(logical.data() + 32, xml.size());
  store<uint64_t>(logical.data() + 16, logical.size() / kLogicalPage * kPhysicalPage);
  std::string out;
  for (size_t page = 0; page < logical.size() / kLogicalPage; ++page) {
    out += logical.substr(page * kLogicalPage, kLogicalPage) + "crc.";
    renew_checksum(out, page);
  }
  return out;
}

}  // namespace

TEST_CASE("e57__is_known_by_its_mark") {
  const OpenedFile marked("ASTM-E57 and more", "a.txt"), other("ASTM-E58");
  CHECK(is_e57(marked));
  CHECK_FALSE(is_e57(other));
  Task task;
  const Failure failure = failure_of([&] { read_e57(marked, {}, task); });
  CHECK(failure.status == (has_codecs() ? Status::kFormat : Status::kUnsupported));
  CHECK(has_text(failure.text, has_codecs() ? "the file ends" : "cargo"));
}

TEST_CASE("e57__files_of_others_hold_what_their_headers_say") {
  static constexpr struct {
    const char* name;
    size_t points, stations;
  } kFiles[] = {{"A4.e57", 4, 1},
                {"A4_moved.e57", 4, 1},
                {"A_B.e57", 6, 2},
                {"A_B_different_dims.e57", 2, 2},
                {"B2.e57", 2, 1},
                {"ColouredCubeFloat.e57", 7680, 1},
                {"ZeroPoints.e57", 0, 1},
                {"bunnyDouble.e57", 30571, 1},
                {"bunnyInt32.e57", 30571, 1}};
  for (const auto& [file, points, stations] : kFiles) {
    const char* const name = file;
    const std::string path = e57_path(name);
    if (path.empty()) return;
    CAPTURE(name);
    const Cloud cloud = read(path);
    CHECK(cloud.size() == points);
    CHECK(cloud.stations.size() == stations);
  }
}

TEST_CASE("e57__malformed_files_are_refused_with_what_is_wrong") {
  static constexpr struct {
    const char *name, *reason;
  } kFiles[] = {{"bad-crc.e57", "checksum"},
                {"InvalidCVHeader.e57", "ection"},
                {"ZeroPointsInvalid.e57", ""},
                {"empty.e57", "no scan"}};
  for (const auto& [file, reason] : kFiles) {
    const char* const name = file;
    const std::string path = e57_path(name);
    if (path.empty()) return;
    CAPTURE(name);
    const Failure failure = failure_of([&] { read(path); });
    CHECK(failure.status == Status::kFormat);
    CHECK(has_text(failure.text, reason));
    CHECK(has_text(failure.text, path));
  }
}

TEST_CASE("e57__a_pose_moves_the_points_of_its_scan_and_is_the_stations") {
  const std::string path = e57_path("A4.e57");
  if (path.empty()) return;
  const Cloud still = read(path);
  CHECK_FALSE(still.stations[0].has_pose);
  CHECK(still.fields.require("red").info().type == ElementType::kUint8);
  CHECK(still.fields.require("intensity").info().type == ElementType::kFloat32);
  // A quarter turn about z, x to y, and a shift.
  const std::string half = "0.70710678118654752440";
  const std::string pose =
      "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">" + half +
      "</w><x type=\"Float\"/><y type=\"Float\">0</y><z type=\"Float\">" + half +
      "</z></rotation><translation type=\"Structure\"><x type=\"Float\">100</x>"
      "<y type=\"Float\">200.5</y><z type=\"Float\">-3</z></translation></pose>";
  const OpenedFile file(with_xml(slurp(path), "<points ", pose), "a.e57");
  const Cloud moved = read(file.path());
  REQUIRE(moved.size() == still.size());
  REQUIRE(moved.stations.size() == 1);
  CHECK(moved.stations[0].has_pose);
  CHECK(moved.stations[0].pose.translation() == Vec3{100, 200.5, -3});
  for (size_t i = 0; i < moved.size(); ++i) {
    const Vec3 p = still.point(i);
    CHECK(norm(moved.point(i) - Vec3{100 - p.y, 200.5 + p.x, p.z - 3}) < 1e-12);
  }
  const OpenedFile lie(
      with_xml(slurp(path), "<points ", std::string(pose).replace(pose.find(half), 1, "9")),
      "b.e57");
  const Failure failure = failure_of([&] { read(lie.path()); });
  CHECK(failure.status == Status::kFormat);
  CHECK(has_text(failure.text, "the pose of scan 1"));
}

TEST_CASE("e57__damaged_pages_with_right_checksums_end_in_an_error_or_in_points") {
  const std::string path = e57_path("A_B.e57");
  if (path.empty()) return;
  const std::string whole = slurp(path);
  Task task;
  size_t refused = 0, read_on = 0;
  for (size_t at = 48; at < whole.size(); at += 5) {
    if (at % 1024 >= 1020) continue;
    for (const char bad : {'\0', '9', '\xff'}) {
      std::string damaged = whole;
      damaged[at] = bad;
      renew_checksum(damaged, at / 1024);
      const OpenedFile file(damaged, "a.e57");
      const Failure failure = failure_of([&] { read_e57(file, {}, task); });
      CHECK((failure.status == Status::kOk || failure.status == Status::kFormat));
      (failure.status == Status::kOk ? read_on : refused) += 1;
    }
  }
  CHECK(refused > 100);
  CHECK(read_on > 100);
}
