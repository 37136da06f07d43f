// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_model.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "geometry/polygon2.h"
#include "model/part_classes.h"
#include "modelling/codes/coded_pipes.h"
#include "modelling/codes/target_objects.h"

namespace jalon {

namespace {

constexpr auto kCodedModelRows = setting_rows(
    number_row<&CodedModelSettings::chord_m>(
        "chord_m", 1e-6, 1, "m", "coded_objects",
        "Farthest that the flat sides of a gutter lie from its round."),
    number_row<&CodedModelSettings::gap_m>(
        "gap_m", 0, 100, "m", "coded_objects",
        "Windows of one facade, of targets, are apart where no point lies for this far along it."));

constexpr double kOnBuilding_m = 0.5;  // a gutter farther from an outline is not that building's

struct Wall {
  CodedWall place;
  uint32_t part = kNoPart;
  std::vector<WallOpening> openings;
};

/// A building, or a wall alone that a target stands for.
struct Body {
  const NotedObject* object = nullptr;
  std::vector<Vec2> outline;  ///< anticlockwise; empty: one wall
  double low_m = 0, high_m = 0;
  std::vector<Wall> walls;
  uint32_t part = kNoPart;
};

std::string named(const NotedObject& o) { return o.name + " (" + std::to_string(o.code) + ")"; }

// Classes 2 and 3 are doors and windows in both ready-made tables; a table of one's own may name them as it likes.
std::string opening_class(const NotedObject& o) {
  if (part_class::is_opening(o.kind)) return o.kind;
  constexpr int64_t kDoorClass = 2, kWindowClass = 3;
  if (o.class_code == kDoorClass) return part_class::kDoor;
  return o.class_code == kWindowClass ? part_class::kWindow : part_class::kOpening;
}

class CodedModel {
 public:
  CodedModel(const Segmentation& segmentation, const CodedModelSettings& settings, Task& task)
      : segmentation_(segmentation),
        settings_(settings),
        task_(task),
        notes_(read_coded_notes(segmentation.notes_json)),
        origin_(origin_of(notes_)),
        faces_(origin_) {}

  // 1. what targets stand for; 2. bodies with their walls; 3. openings, each in the nearest wall that holds it;
  // 4. faces: bodies, openings of no wall, gutters.
  Model run() {
    targets_ = target_shapes(segmentation_, notes_, origin_, settings_.gap_m, task_);
    for (size_t i = 0; i < notes_.objects.size(); ++i) add_body(notes_.objects[i], targets_[i]);
    for (size_t i = 0; i < notes_.objects.size(); ++i) add_openings(notes_.objects[i], targets_[i]);
    std::vector<const CodedOpening*> loose;
    for (const CodedOpening& opening : openings_)
      if (!stand_in_wall(opening)) loose.push_back(&opening);
    for (Body& body : bodies_) draw(body);
    for (const CodedOpening* opening : loose)
      faces_.add(faces_.part(opening->name, opening->part_class, kNoParent), opening->id,
                 opening->border);
    for (size_t i = 0; i < notes_.objects.size(); ++i) draw_pipe(notes_.objects[i], targets_[i]);
    return faces_.take(segmentation_.cloud->crs);
  }

 private:
  static Vec3 origin_of(const CodedNotes& notes) {
    for (const NotedObject& o : notes.objects)
      if (!o.surveyed.empty()) {
        const Vec3& p = o.surveyed.front().place;
        return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
      }
    return {};
  }

  // A building without a low point stands as low as its points reach; without points there is no telling.
  double foot_of(const NotedObject& o) const {
    if (std::isfinite(o.low_m)) return o.low_m - origin_.z;
    double low = INFINITY;
    const auto labels = segmentation_.labels->values<uint32_t>();
    for (size_t i = 0; o.label != 0 && i < labels.size(); ++i)
      if (labels[i] == o.label) low = std::min(low, segmentation_.cloud->point(i).z - origin_.z);
    return low;
  }

  void add_body(const NotedObject& o, const MeasuredShape& target) {
    if (o.geometry == "wall_target") {
      for (const CodedWall& wall : target.rectangles)
        bodies_.push_back({&o, {}, wall.low_m, wall.high_m, {{wall, kNoPart, {}}}, kNoPart});
      return;
    }
    if (o.shape != "prism" || o.outline.size() < 3) return;
    Body body{&o, {}, foot_of(o), o.high_m - origin_.z, {}, kNoPart};
    if (!(body.low_m < body.high_m)) return;
    for (const Vec3& p : o.outline) body.outline.push_back({p.x - origin_.x, p.y - origin_.y});
    if (signed_area(body.outline) < 0) std::reverse(body.outline.begin(), body.outline.end());
    for (size_t i = 0; i < body.outline.size(); ++i)
      body.walls.push_back(
          {{body.outline[i], body.outline[(i + 1) % body.outline.size()], body.low_m, body.high_m},
           kNoPart,
           {}});
    bodies_.push_back(std::move(body));
  }

  void add_openings(const NotedObject& o, const MeasuredShape& target) {
    if (o.shape == "rectangle" || o.shape == "outline") {
      openings_.push_back({named(o), opening_class(o), o.label, {}});
      for (const Vec3& p : o.outline) openings_.back().border.push_back(p - origin_);
      return;
    }
    if (o.geometry != "door_target" && o.geometry != "window_target") return;
    size_t number = 0;
    for (const CodedWall& r : target.rectangles) {
      const bool one_of_many = target.rectangles.size() > 1;
      const std::string name = o.name + (one_of_many ? "." + std::to_string(++number) : "");
      const char* what = o.geometry == "door_target" ? part_class::kDoor : part_class::kWindow;
      const double width = r.length_m();
      openings_.push_back({name + " (" + std::to_string(o.code) + ")",
                           what,
                           o.label,
                           {r.point(0, r.low_m), r.point(width, r.low_m), r.point(width, r.high_m),
                            r.point(0, r.high_m)}});
    }
  }

  bool stand_in_wall(const CodedOpening& opening) {
    Wall* nearest = nullptr;
    std::optional<WallOpening> in_nearest;
    for (Body& body : bodies_)
      for (Wall& wall : body.walls) {
        auto found = opening_in(wall.place, opening);
        if (!found || (in_nearest && in_nearest->depth_m <= found->depth_m)) continue;
        nearest = &wall;
        in_nearest = std::move(found);
      }
    if (nearest == nullptr) return false;
    for (const WallOpening& other : nearest->openings)
      if (overlap(other, *in_nearest)) return false;
    nearest->openings.push_back(std::move(*in_nearest));
    return true;
  }

  void draw(Body& body) {
    const NotedObject& o = *body.object;
    if (body.outline.empty()) {
      body.part = faces_.part(named(o), part_class::kWall, kNoParent);
      add_coded_wall(faces_, body.walls.front().place, body.part, o.label,
                     body.walls.front().openings);
      return;
    }
    body.part = faces_.part(named(o), part_class::kBuilding, kNoParent);
    const size_t first = faces_.size();
    Corners foot, top;
    size_t number = 0;
    bool has_openings = false;
    for (Wall& wall : body.walls) {
      wall.part = faces_.part("wall " + std::to_string(++number), part_class::kWall, body.part);
      has_openings = has_openings || !wall.openings.empty();
      const Corners part_of_foot =
          add_coded_wall(faces_, wall.place, wall.part, o.label, wall.openings);
      foot.insert(foot.end(), part_of_foot.begin(), part_of_foot.end() - 1);
      top.push_back({wall.place.a.u, wall.place.a.v, body.high_m});
    }
    // Nobody measured a roof: the prism ends at the height of its highest corner.
    faces_.add(faces_.part("top", part_class::kRoof, body.part, Evidence::kDerived), o.label, top);
    std::reverse(foot.begin(), foot.end());
    faces_.add(faces_.part("foot", part_class::kGround, body.part, Evidence::kDerived), o.label,
               foot);
    faces_.close(body.part, first);
    faces_.at(body.part).level_of_detail = has_openings ? 3 : 2;
  }

  void draw_pipe(const NotedObject& o, const MeasuredShape& target) {
    std::vector<Vec3> axis = target.axis;
    const bool is_measured = o.shape == "cylinder";
    for (const Vec3& p : o.axis) axis.push_back(p - origin_);
    if (axis.size() < 2) return;
    const Vec2 foot{axis[0].x, axis[0].y};
    uint64_t parent = kNoParent;
    double nearest = kOnBuilding_m;
    for (const Body& body : bodies_) {
      if (body.outline.empty()) continue;
      const double distance = border_distance(body.outline, foot);
      if (distance >= nearest) continue;
      nearest = distance;
      parent = body.part;
    }
    add_coded_pipe(faces_, faces_.part(named(o), o.kind, parent), o.label, axis,
                   is_measured ? o.radius_m : target.radius_m, settings_.chord_m);
  }

  const Segmentation& segmentation_;
  const CodedModelSettings& settings_;
  Task& task_;
  const CodedNotes notes_;
  const Vec3 origin_;
  SharedFaces faces_;
  std::vector<MeasuredShape> targets_;
  std::vector<Body> bodies_;
  std::vector<CodedOpening> openings_;
};

}  // namespace

std::span<const ParamRow> coded_model_rows() { return kCodedModelRows; }

Model model_coded_objects(const Segmentation& segmentation, const CodedModelSettings& settings,
                          Task& task) {
  if (segmentation.notes_json.empty() && !segmentation.segments.empty())
    fail(Status::kInsufficientData,
         "the segmentation is not one by codes: use segmenter survey_codes or target_codes");
  return CodedModel(segmentation, settings, task).run();
}

}  // namespace jalon
