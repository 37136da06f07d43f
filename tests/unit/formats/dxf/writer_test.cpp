// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Whole DXF files: sections in the order of the DXF Reference, handles one after the other, whole or not at all.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "formats/dxf/dxf.h"
#include "unit/formats/dxf/tags.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<TagItem> dxf_file(const Model& model, const WriteSettings& settings) {
  const Folder folder;
  Task task;
  write_dxf(model, folder.file("a.dxf"), settings, task);
  CHECK(folder.entries() == 1);
  return tag_items(slurp(folder.file("a.dxf")));
}

/// A grid of triangles in the plane z = 0.
Model triangle_grid(uint32_t n) {
  Model model;
  for (uint32_t i = 0; i <= n; ++i)
    for (uint32_t k = 0; k <= n; ++k)
      model.vertices.push_back({652000.123456 + i, 6861000.654321 + k, 0});
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = i * (n + 1) + k, b = a + n + 1;
      model.triangles.push_back({a, b, b + 1});
      model.triangles.push_back({a, b + 1, a + 1});
    }
  model.triangle_faces.assign(model.triangles.size(), 0);
  return model;
}

}  // namespace

TEST_CASE("dxf_writer__sections_stand_in_their_order_and_the_file_has_its_end") {
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000})
    for (const DxfView view : {DxfView::kWorld, DxfView::kElevation}) {
      WriteSettings settings;
      settings.dxf_version = version;
      settings.dxf_view = view;
      std::string sections;
      size_t ends = 0;
      const std::vector<TagItem> items = dxf_file(House().model(), settings);
      for (const TagItem& item : items) {
        if (item.kind() == "SECTION") sections += item.text(2) + " ";
        ends += item.kind() == "ENDSEC" ? 1 : 0;
      }
      const bool old = version == DxfVersion::kR12;
      CHECK(sections == (old ? "HEADER TABLES BLOCKS ENTITIES "
                             : "HEADER CLASSES TABLES BLOCKS ENTITIES OBJECTS "));
      CHECK(ends == (old ? 4 : 6));
      CHECK(items.back().kind() == "EOF");
    }
}

TEST_CASE("dxf_writer__a_file_of_several_pieces_has_every_triangle_in_place_and_handles_in_a_row") {
  Model model = triangle_grid(60);
  Face bent;  // a polyline in space takes a handle for itself, each vertex and its end
  bent.id = 77;
  model.add_face(bent, {{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}});
  const std::vector<TagItem> items = dxf_file(model, {});
  size_t t = 0, wrong = 0;
  uint64_t last = 0;
  for (const TagItem& item : items) {
    if (item.kind() != "3DFACE") continue;
    REQUIRE(t < model.triangles.size());
    for (int k = 0; k < 3; ++k)
      wrong += Vec3{item.number(10 + k), item.number(20 + k), item.number(30 + k)} !=
               model.vertices[model.triangles[t][static_cast<size_t>(k)]];
    const uint64_t handle = std::stoull(item.text(5), nullptr, 16);
    wrong += t > 0 && handle != last + 1;
    last = handle;
    ++t;
  }
  CHECK(wrong == 0);
  CHECK(t == 7200);  // about 2 MiB of text
  std::string seed;
  for (size_t i = 0; i + 1 < items[0].tags.size(); ++i)
    if (items[0].tags[i].value == "$HANDSEED") seed = items[0].tags[i + 1].value;
  CHECK(std::stoull(seed, nullptr, 16) == last + 1);  // the first that is free
}

TEST_CASE("dxf_writer__an_impossible_model_or_a_cancel_leaves_the_file_that_was_there") {
  const Folder folder;
  spill(folder.file("a.dxf"), "before");
  Model model = triangle_grid(2);
  const std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  const auto refusal = [&](const Task::Hooks& with) {
    Task task(with);
    const Failure failure = failure_of([&] { write_dxf(model, folder.file("a.dxf"), {}, task); });
    CHECK(slurp(folder.file("a.dxf")) == "before");
    CHECK(folder.entries() == 1);
    return failure;
  };
  CHECK(refusal(hooks).status == Status::kCancelled);
  model.vertices[5].y = 1e200;  // the size of the window it opens in is beyond every number
  CHECK(refusal({}).status == Status::kUnsupported);
  model.vertices[5].y = NAN;
  const Failure failure = refusal({});
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(failure.text.find("vertex 5") != std::string::npos);
}

TEST_CASE("dxf_writer__sections_of_a_cloud_are_polylines_on_layers_of_their_own") {
  Sections sections;
  sections.kind = SectionKind::kHeight;
  for (const double at : {1.5, 3.0}) {
    Section section;
    section.plane = {at, {652000, 6861000, at}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    SectionLine line;
    line.vertices = {{0, 0}, {6, 0}, {6, 3}};
    line.is_closed = at == 3;
    section.lines.push_back(line);
    sections.sections.push_back(section);
  }
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000}) {
    const Folder folder;
    Task task;
    WriteSettings settings;
    settings.dxf_version = version;
    write_dxf(sections, folder.file("a.dxf"), settings, task);
    const bool old = version == DxfVersion::kR12;
    std::string layers;
    std::vector<std::string> drawn, closed;
    for (const TagItem& item : tag_items(slurp(folder.file("a.dxf")))) {
      if (item.kind() == "LAYER") layers += item.text(2) + " ";
      if (item.kind() != (old ? "POLYLINE" : "LWPOLYLINE")) continue;
      drawn.push_back(item.text(8));
      closed.push_back(item.text(70));
    }
    CHECK(layers == (old ? "0 Z_1_500 Z_3_000 " : "0 Z_1.500 Z_3.000 "));
    CHECK(drawn == (old ? std::vector<std::string>{"Z_1_500", "Z_3_000"}
                        : std::vector<std::string>{"Z_1.500", "Z_3.000"}));
    CHECK(closed ==
          (old ? std::vector<std::string>{"8", "9"} : std::vector<std::string>{"0", "1"}));
  }
}
