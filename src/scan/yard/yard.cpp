// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/yard.h"

#include "base/json_writer.h"
#include "scan/builder/scene_frame.h"
#include "scan/yard/code_lists.h"
#include "scan/yard/sheets.h"

namespace jalon {

namespace {

constexpr uint64_t kFittingStream = 1ull << 34;

std::vector<uint8_t> build(const yard::Plan& plan, uint64_t seed, SceneBuilder& out) {
  yard::Sheets sheets(out);
  uint64_t number = 0;
  for (const yard::Side& side : plan.sides) {
    add_sheet_wall(sheets, side, plan.targets);
    for (const yard::Opening& o : side.openings)
      add_fittings(sheets, side, o, {seed, kFittingStream + ++number});
  }
  const uint32_t part = sheets.part("targets", "target");
  constexpr yard::PointClass kOf[] = {yard::kRest, yard::kWall, yard::kDoor, yard::kWindow};
  for (const yard::Target& t : plan.targets)
    if (t.has_patch)
      sheets.rect(part, kOf[t.code], t.frame,
                  {t.u_m - yard::kTargetHalf_m, t.u_m + yard::kTargetHalf_m,
                   t.v_m - yard::kTargetHalf_m, t.v_m + yard::kTargetHalf_m});
  add_surroundings(sheets, plan, seed);
  return sheets.classes();
}

}  // namespace

void build_yard(const SceneSettings& settings, SceneBuilder& out) {
  build(yard::plan_of(settings.yard, settings.seed), settings.seed, out);
}

YardTruth yard_truth(const SceneSettings& settings) {
  const Transform T_world_scene =
      scene_frame(settings, 0, {kYardShift_m[0], kYardShift_m[1], kYardShift_m[2]});
  const yard::Plan plan = yard::plan_of(settings.yard, settings.seed);
  SceneBuilder builder(T_world_scene);
  YardTruth truth;
  truth.face_classes = build(plan, settings.seed, builder);
  truth.survey = yard::survey_lines(plan, settings.yard, settings.seed, T_world_scene);
  truth.targets = yard::target_lines(plan, T_world_scene);
  return truth;
}

std::string json_of(const YardTruth& truth, const SceneSettings& settings) {
  constexpr const char* kNames[] = {"rest", "wall", "door", "window", "gutter"};
  JsonWriter json;
  json.begin_object().name("shape").value("jalon coded truth 1").name("scene").value("yard");
  json.name("seed").value(settings.seed).name("classes").begin_array();
  for (int c = 0; c < 5; ++c)
    json.begin_object().name("class").value(c).name("name").value(kNames[c]).end_object();
  json.end_array().name("survey").begin_array();
  for (const std::string& line : truth.survey) json.value(line);
  json.end_array().name("targets").begin_array();
  for (const std::string& line : truth.targets) json.value(line);
  json.end_array().name("face_classes").begin_array();
  for (const uint8_t c : truth.face_classes) json.value(static_cast<int>(c));
  return json.end_array().end_object().take();
}

}  // namespace jalon
