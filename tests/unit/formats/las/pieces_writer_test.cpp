// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// LAS and LAZ written piece by piece against the same cloud written whole.
#include <doctest/doctest.h>

#include "cloud/operations.h"
#include "formats/codecs/codecs.h"
#include "formats/las/las.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr size_t kPoints = 120001;  // chunks of LAZ of 50 000, and one point

Cloud many_fields(bool is_extended) {
  Cloud cloud = random_points(kPoints, 3);
  RandomStream random(3, 2);
  cloud.fields.set(random_column("intensity", ElementType::kUint16, 1, kPoints, random));
  cloud.fields.set(random_column("gps_time", ElementType::kFloat64, 1, kPoints, random));
  cloud.fields.set(random_column("three", ElementType::kInt16, 3, kPoints, random));
  if (is_extended) cloud.fields.set(random_column("nir", ElementType::kUint16, 1, kPoints, random));
  return cloud;
}

Cloud part(const Cloud& cloud, size_t first, size_t end) {
  std::vector<uint64_t> kept;
  for (size_t i = first; i < end; ++i) kept.push_back(i);
  Task task;
  return select(cloud, kept, task);
}

/// Pieces of lengths that fit no chunk.
bool put_all(const Cloud& cloud, CloudSink& sink) {
  Task task;
  for (size_t first = 0, size = 1; first < cloud.size(); first += size, size = 3 * size + 1)
    if (!sink.put(part(cloud, first, std::min(first + size, cloud.size())), task)) return false;
  sink.finish(task);
  return true;
}

}  // namespace

TEST_CASE("las_pieces__are_written_to_the_bytes_of_the_whole_cloud") {
  const Folder folder;
  for (const bool is_extended : {false, true}) {
    write(many_fields(is_extended), folder.file("origin.las"));
    const Cloud cloud = read(folder.file("origin.las"));
    write(cloud, folder.file("whole.las"));
    REQUIRE(put_all(cloud, *las_sink(folder.file("pieces.las"), {}, cloud.size())));
    CHECK(slurp(folder.file("pieces.las")) == slurp(folder.file("whole.las")));
    if (!has_codecs()) continue;
    write(cloud, folder.file("whole.laz"));
    REQUIRE(put_all(cloud, *laz_sink(folder.file("pieces.laz"), {}, cloud.size())));
    CHECK(slurp(folder.file("pieces.laz")) == slurp(folder.file("whole.laz")));
  }
}

TEST_CASE("las_pieces__of_other_steps_or_fields_are_refused_and_no_file_is_left") {
  const Folder folder;
  Task task;
  const Cloud here = random_points(10, 1), far = random_points(10, 1, {900000, 6861000, 100});
  Cloud more = here;
  RandomStream random(1, 2);
  more.fields.set(random_column("intensity", ElementType::kUint16, 1, 10, random));
  for (const Cloud* other : {&far, static_cast<const Cloud*>(&more)}) {
    const auto sink = las_sink(folder.file("a.las"), {}, 20);
    CHECK(sink->put(here, task));
    CHECK(!sink->put(*other, task));
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("las_pieces__of_no_las_file_have_the_steps_of_the_whole_once_they_are_told_its_bounds") {
  const Folder folder;
  Task task;
  const Cloud cloud = random_points(kPoints, 5);
  write(cloud, folder.file("whole.las"));
  const auto sink = las_sink(folder.file("pieces.las"), {}, cloud.size());
  REQUIRE(sink->asks_for_bounds(part(cloud, 0, 100), task));
  sink->tell_bounds(bounds(cloud, task));
  REQUIRE(put_all(cloud, *sink));
  CHECK(slurp(folder.file("pieces.las")) == slurp(folder.file("whole.las")));
  const Cloud of_las = read(folder.file("whole.las"));
  CHECK(!las_sink(folder.file("b.las"), {}, 1)->asks_for_bounds(of_las, task));
  WriteSettings steps;
  steps.scale = 0.01;
  CHECK(las_sink(folder.file("b.las"), steps, 1)->asks_for_bounds(of_las, task));
}

TEST_CASE("las_pieces__more_than_two_to_the_32_are_of_the_version_that_counts_them") {
  const Folder folder;
  Task task;
  const auto sink = las_sink(folder.file("a.las"), {}, uint64_t{1} << 32);
  REQUIRE(sink->put(random_points(10, 1), task));
  sink->finish(task);
  CHECK(slurp(folder.file("a.las"))[25] == 4);
}

TEST_CASE("las_pieces__read_one_after_another_are_the_cloud") {
  const Folder folder;
  Task task;
  write(many_fields(false), folder.file("a.las"));
  const Cloud whole = read(folder.file("a.las"));
  const ByteSource source(folder.file("a.las"));
  const auto pieces = las_pieces(source, {}, task);
  REQUIRE(pieces != nullptr);
  CHECK(pieces->count() == kPoints);
  size_t first = 0;
  for (Cloud piece; pieces->next(7000, piece, task); first += piece.size()) {
    CHECK(piece.size() == std::min<size_t>(7000, kPoints - first));
    const Cloud same = part(whole, first, first + piece.size());
    CHECK(std::ranges::equal(piece.xyz(), same.xyz()));
    for (const ColumnPtr& column : same.fields)
      CHECK(same_values(*piece.fields.find(column->info().name.c_str()), *column));
  }
  CHECK(first == kPoints);
}
