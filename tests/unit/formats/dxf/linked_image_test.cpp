// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Links to pictures whose world files put them on the facade of the house.
#include "formats/dxf/linked_image.h"

#include <cmath>

#include "formats/png/pictures.h"
#include "formats/dxf/dxf.h"
#include "formats/facade_views.h"
#include "unit/formats/dxf/tags.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPlaceRounding_m = 1e-8;

/// A picture of 60 x 40 pixels of 0.2 m over the wall of the house, its world file as given.
struct Pictured {
  explicit Pictured(const std::string& world = "0.2\n0\n0\n-0.2\n0.1\n150.4\n") {
    Task task;
    spill(folder.file("a.png"), png_of(RgbaImage{60, 40, std::vector<uint8_t>(9600, 9)}, task));
    spill(folder.file("a.pgw"), world);
  }
  Folder folder;
  std::vector<dxf::LinkedImage> linked(bool in_space) const {
    return dxf::linked_images(folder.file("a.png"), folder.file("a.dxf"), House().model(),
                              in_space);
  }
  Failure failure() const {
    return failure_of([&] { linked(true); });
  }
};

}  // namespace

TEST_CASE("dxf_linked_image__lies_on_the_sheet_of_the_elevation_and_on_its_wall_in_space") {
  const Pictured picture;
  const auto flat = picture.linked(false), spatial = picture.linked(true);
  REQUIRE(flat.size() == 1);
  CHECK(flat[0].link == "a.png");
  CHECK(flat[0].columns == 60);
  CHECK(flat[0].rows == 40);
  CHECK(norm(flat[0].at - Vec3{0, 142.5, 0}) < kPlaceRounding_m);
  CHECK(norm(flat[0].right - Vec3{0.2, 0, 0}) < 1e-12);
  // The house's wall begins at its left foot, and the picture spans its 12 x 8 m.
  const Model model = House().model();
  const Vec3 foot = model.vertices[model.corners[0]];
  CHECK(norm(spatial[0].at - foot) < kPlaceRounding_m);
  CHECK(norm(spatial[0].at + spatial[0].right * 60 + spatial[0].up * 40 -
             model.vertices[model.corners[2]]) < kPlaceRounding_m);
}

TEST_CASE("dxf_linked_image__the_drawing_ties_entity_definition_and_dictionary_together") {
  const Pictured picture;
  Task task;
  WriteSettings settings;
  settings.dxf_images = picture.folder.file("a.png");
  write_dxf(House().model(), picture.folder.file("a.dxf"), settings, task);
  const std::vector<TagItem> items = tag_items(slurp(picture.folder.file("a.dxf")));
  const auto only = [&](const char* kind) {
    const TagItem* found = nullptr;
    for (const TagItem& item : items)
      if (item.kind() == kind) found = &item;
    REQUIRE(found != nullptr);
    return *found;
  };
  const TagItem image = only("IMAGE"), definition = only("IMAGEDEF"),
                reactor = only("IMAGEDEF_REACTOR");
  CHECK(image.text(340) == definition.text(5));
  CHECK(image.text(360) == reactor.text(5));
  CHECK(image.text(8) == "ORTHOIMAGE");
  CHECK(definition.text(1) == "a.png");
  CHECK(reactor.all(330).back() == image.text(5));
  settings.dxf_version = DxfVersion::kR12;
  CHECK(failure_of([&] {
          write_dxf(House().model(), picture.folder.file("b.dxf"), settings, task);
        }).status == Status::kUnsupported);
  CHECK(!std::filesystem::exists(picture.folder.file("b.dxf")));
}

TEST_CASE("dxf_linked_image__what_is_wrong_with_a_picture_is_told") {
  for (const char* world : {"", "0.2 0 0 -0.2 0.1", "0.2 0 0 -0.2 0.1 x", "0.2 0.1 0 -0.2 0.1 150",
                            "0.2 0 0 0.2 0.1 150", "-1 0 0 1 0 0", "nan 0 0 -0.2 0 0"})
    CHECK(Pictured(world).failure().status == Status::kFormat);
  CHECK(Pictured("0.2 0 0 -0.2 900 150").failure().status == Status::kInvalidArgument);
  const Pictured picture;
  spill(picture.folder.file("a.png"), "GIF89a");
  CHECK(picture.failure().text.ends_with("an image of a drawing is a PNG file, this is none"));
  std::filesystem::remove(picture.folder.file("a.png"));
  CHECK(picture.failure().status == Status::kNotFound);
}

TEST_CASE("dxf_linked_image__a_picture_elsewhere_is_named_by_its_path") {
  const Pictured picture;
  const auto images = dxf::linked_images("|" + picture.folder.file("a.png") + "|", "other/a.dxf",
                                         House().model(), false);
  REQUIRE(images.size() == 1);
  CHECK(images[0].link == picture.folder.file("a.png"));
}
