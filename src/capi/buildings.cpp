// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/buildings.h"

#include "base/table_columns.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "model/buildings/building_offsets.h"
#include "model/buildings/building_tree.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

FieldTable strip_table(const BuildingTree& tree) {
  using S = BuildingStrip;
  const auto& rows = tree.strips;
  const auto facade = [&](const S& s) -> const BuildingFacade& { return tree.facades[s.facade]; };
  const auto put = [](const Vec3& v, double* out) { out[0] = v.x, out[1] = v.y, out[2] = v.z; };
  FieldTable t;
  add_column<uint32_t>(t, rows, "block", "", "its number",
                       [&](const S& s) { return tree.block_of(facade(s)); });
  add_column<uint32_t>(t, rows, "building", "", "its number",
                       [&](const S& s) { return facade(s).building; });
  add_column<uint32_t>(t, rows, "facade", "", "its number", [](const S& s) { return s.facade; });
  // The strips' parts stand behind all others, in their order.
  const size_t first = tree.blocks + tree.buildings.size() + tree.facades.size();
  add_column<uint32_t>(t, rows, "part", "", "of the model of strips",
                       [&](const S& s) { return first + static_cast<size_t>(&s - rows.data()); });
  add_columns<double, 3>(t, rows, "normal", "1", "level, out of the building",
                         [&](const S& s, double* o) { put(facade(s).normal, o); });
  add_columns<double, 3>(
      t, rows, "place", "m", "lower left corner, seen from outside", [&](const S& s, double* o) {
        put(facade(s).place({s.from_m, facade(s).bottom_m}) + facade(s).normal * s.offset_m, o);
      });
  add_column<double>(t, rows, "width", "m", "along the facade",
                     [](const S& s) { return s.to_m - s.from_m; });
  add_column<double>(t, rows, "height", "m", "of the facade",
                     [&](const S& s) { return facade(s).top_m - facade(s).bottom_m; });
  add_column<uint8_t>(t, rows, "turned", "", "1: the face looked inward",
                      [&](const S& s) { return facade(s).was_turned ? 1 : 0; });
  return t;
}

Model strips_with_others(const BuildingTree& tree, const Model& buildings,
                         const BuildingSettings& settings) {
  Model made = strip_model(tree);
  if (settings.others) add_others(made, tree, buildings);
  return made;
}

FieldTable block_table(const std::vector<Vec2>& offsets) {
  FieldTable t;
  add_columns<double, 2>(t, offsets, "offset", "m", "east and north",
                         [](const Vec2& v, double* o) { o[0] = v.u, o[1] = v.v; });
  return t;
}

FieldTable offset_table(const std::vector<double>& offsets, const char* meaning) {
  FieldTable t;
  add_column<double>(t, offsets, "offset", "m", meaning, [](double v) { return v; });
  return t;
}

}  // namespace

jalon_status jalon_model_building_strips(const jalon_model* buildings, const jalon_params* options,
                                         jalon_task* task, jalon_model** model,
                                         jalon_fields** strips) {
  return guard([&] {
    require(buildings, "buildings");
    const auto settings =
        settings_from<BuildingSettings>(options_or_default(options, "building_strips"));
    Owned<jalon_model> made = own<jalon_model>(nullptr);
    Owned<jalon_fields> table = own<jalon_fields>(nullptr);
    with_task(task, [&](Task& t) {
      const BuildingTree tree = building_tree(*buildings->model, settings, t);
      if (model != nullptr)
        made.reset(new_model(strips_with_others(tree, *buildings->model, settings)));
      if (strips != nullptr) table.reset(new_fields(strip_table(tree)));
    });
    if (model != nullptr) *model = made.release();
    if (strips != nullptr) *strips = table.release();
  });
}

jalon_status jalon_model_perturb_strips(const jalon_model* strips, const jalon_params* options,
                                        jalon_model** model, jalon_fields** block_offsets,
                                        jalon_fields** facade_offsets,
                                        jalon_fields** strip_offsets) {
  return guard([&] {
    require(strips, "strips");
    const auto sigmas =
        settings_from<BuildingSigmas>(options_or_default(options, "building_sigmas"));
    const BuildingOffsets drawn = drawn_offsets(*strips->model, sigmas);
    Owned<jalon_model> moved = own(new_model(moved_strips(*strips->model, drawn)));
    Owned<jalon_fields> blocks = own(new_fields(block_table(drawn.blocks)));
    Owned<jalon_fields> facades = own(new_fields(offset_table(drawn.facades, "along its normal")));
    Owned<jalon_fields> of_strips =
        own(new_fields(offset_table(drawn.strips, "along its facade's normal")));
    if (model != nullptr) *model = moved.release();
    if (block_offsets != nullptr) *block_offsets = blocks.release();
    if (facade_offsets != nullptr) *facade_offsets = facades.release();
    if (strip_offsets != nullptr) *strip_offsets = of_strips.release();
  });
}
