// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What release 2000 must have besides entities, as the DXF Reference ties it together: owners, entries, classes.
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "formats/dxf/sections.h"
#include "unit/formats/dxf/tags.h"

using namespace jalon;
using namespace jalon::test;
using dxf::Version;

namespace {

std::vector<TagItem> objects_of(const dxf::Drawing& drawing) {
  dxf::Text text(Version::kR2000);
  dxf::add_objects(text, drawing);
  return tag_items(text.take());
}

std::vector<TagItem> blocks_of(Version version) {
  dxf::Text text(version);
  dxf::add_blocks(text);
  return tag_items(text.take());
}

bool is_frame(const TagItem& item) { return item.kind() == "SECTION" || item.kind() == "ENDSEC"; }

}  // namespace

TEST_CASE("dxf_objects__every_object_is_an_entry_of_the_dictionary_that_owns_it") {
  const std::vector<TagItem> items = objects_of({});
  std::map<std::string, std::set<std::string>> entries;  // of each dictionary, by handle
  std::set<std::string> handles;
  for (const TagItem& item : items) {
    if (is_frame(item)) continue;
    CHECK(handles.insert(item.text(5)).second);
    CHECK(item.all(3).size() >= item.all(350).size());  // a name for each
    for (const std::string& entry : item.all(350)) entries[item.text(5)].insert(entry);
  }
  std::string root;
  for (const TagItem& item : items) {
    if (is_frame(item)) continue;
    const std::string owner = item.text(330);
    CAPTURE(item.kind());
    if (owner == "0") {
      CHECK(root.empty());
      root = item.text(5);
      CHECK(item.kind() == "DICTIONARY");
    } else {
      CHECK(entries[owner].erase(item.text(5)) == 1);
    }
  }
  CHECK(!root.empty());
  for (const auto& [dictionary, left] : entries) CHECK(left.empty());  // none leads nowhere
}

TEST_CASE("dxf_objects__kinds_that_are_not_built_in_are_declared_as_classes") {
  dxf::Text text(Version::kR2000);
  dxf::add_classes(text, {});
  std::set<std::string> declared, used;
  for (const TagItem& item : tag_items(text.take()))
    if (item.kind() == "CLASS") CHECK(declared.insert(item.text(1)).second);
  for (const TagItem& item : objects_of({}))
    if (!is_frame(item)) used.insert(item.kind());
  const std::set<std::string> built_in{"DICTIONARY",
                                       "MLINESTYLE"};  // DXF Reference, OBJECTS section
  for (const std::string& kind : used) CHECK(declared.contains(kind) != built_in.contains(kind));
  for (const std::string& kind : declared) CHECK(used.contains(kind));
}

TEST_CASE("dxf_objects__the_model_layout_shows_the_extent_of_the_drawing") {
  dxf::Drawing drawing;
  for (const bool empty : {true, false}) {
    const Vec3 low = empty ? Vec3{} : Vec3{-3, 4, 5}, high = empty ? Vec3{} : Vec3{30, 40, 50.5};
    if (!empty) drawing.box.add(low);
    if (!empty) drawing.box.add(high);
    std::map<std::string, TagItem> layouts;  // by the block record they belong to
    for (const TagItem& item : objects_of(drawing))
      if (item.kind() == "LAYOUT") layouts[item.all(330).back()] = item;
    REQUIRE(layouts.size() == 2);
    const TagItem& model = layouts["1F"];  // dxf::kModelSpace
    CHECK(Vec3{model.number(14), model.number(24), model.number(34)} == low);
    CHECK(Vec3{model.number(15), model.number(25), model.number(35)} == high);
    CHECK(model.all(1).back() == "Model");
    CHECK(layouts["23"].all(1).back() == "Layout1");  // dxf::kPaperSpace
  }
}

TEST_CASE("dxf_objects__release_2000_has_the_blocks_of_model_and_paper_and_release_12_none") {
  const std::vector<TagItem> items = blocks_of(Version::kR2000);
  REQUIRE(items.size() == 6);
  const char* kNames[] = {"*Model_Space", "*Paper_Space"};
  for (size_t b = 0; b < 2; ++b) {
    const TagItem &begin = items[1 + 2 * b], &end = items[2 + 2 * b];
    CHECK(begin.kind() == "BLOCK");
    CHECK(end.kind() == "ENDBLK");
    CHECK(begin.text(2) == kNames[b]);
    CHECK(begin.text(3) == kNames[b]);
    CHECK(begin.text(330) == end.text(330));  // one block record
    CHECK(begin.text(5) != end.text(5));
    CHECK(begin.text(67) == (b == 1 ? "1" : ""));  // in paper space
  }
  const std::vector<TagItem> old = blocks_of(Version::kR12);
  REQUIRE(old.size() == 2);
  CHECK(old[0].text(2) == "BLOCKS");
}
