// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/task.h"
#include "formats/dxf/linked_image.h"
#include "formats/dxf/text.h"
#include "model/model.h"

namespace jalon::dxf {

struct Layer {
  std::string name;
  int colour =
      7;  ///< AutoCAD colour index: 1 red, 2 yellow, 3 green, 4 cyan, 5 blue, 6 magenta, 7 black or white
  bool dashed = false;  ///< copied elements and areas without data
};

/// Layers by the class of what lies on them; layer 0 is first, as every drawing has it.
class Layers {
 public:
  Layers() : layers_{{"0", 7, false}}, index_{{"0", 0}} {}
  /// The layer of a part: its class in capitals, "-COPIED" behind it for copies.
  uint32_t of_part(const Model& model, uint32_t part);
  /// By its own name, made safe for the release.
  uint32_t named(const std::string& name, int colour, DxfVersion version);
  /// A class that no part stands for, e.g. openings of unknown kind.
  uint32_t of_class(const std::string& part_class, bool copied = false);
  const std::vector<Layer>& all() const { return layers_; }

 private:
  std::vector<Layer> layers_;
  std::map<std::string, uint32_t> index_;
};

/// A chain of lines and arcs in a plane of this normal.
struct Polyline {
  std::vector<Vec3> corners;
  std::vector<double>
      sagittas_m;  ///< as Model::sagittas, seen against the normal; empty: all straight
  Vec3 normal;
  uint32_t layer = 0;
  uint32_t part = kNoPart;
  uint32_t face_id = 0;
  bool is_closed = true;
  bool is_ring = true;  ///< of a face, which it then tells as application data
};

/// A number on a face, as high as it can be read with the face in view.
struct Label {
  Vec3 at, normal;  ///< its middle
  double height_m = 0;
  std::string text;
  uint32_t layer = 0;
};

/// What goes into the file.
struct Drawing {
  Layers layers;
  std::vector<Polyline> polylines;
  std::vector<Label> labels;
  std::vector<std::array<uint32_t, 3>> triangles;  ///< of the model's vertices
  std::vector<uint32_t> triangle_layers;
  std::vector<LinkedImage> images;  ///< behind all others
  uint32_t image_layer = 0;
  Box3 box;
  Vec3 view_direction{0, 0, 1};  ///< from the drawing to the viewer, for the window it opens in
};

/// Rings and triangles where they are in space.
Drawing draw_world(const Model& model, Task& task);

/// The facades flattened into the drawing plane, 1:1: x along the facade from its left end, y = height. Faces seen
/// edge-on are left out, and of solids those that look away; arcs of faces that do not lie in the plane of the facade
/// become chords. Several facades (parts of this class) stand side by side.
Drawing draw_elevation(const Model& model, double chord_error_m, Task& task);

/// One ring as a polyline; nothing when it has no extent.
void add_ring(Drawing& drawing, const Model& model, const Face& face, uint64_t ring,
              const Vec3& normal);

/// The outline of a face once more for each of these openings, on their layers.
void add_openings(Drawing& drawing, const Model& model, const Face& face, const Vec3& normal,
                  const std::vector<uint32_t>& openings);
/// Of each face the openings that its outline alone shows: doors at the foot of their wall are no holes of it, and what
/// is drawn of them is their joinery.
std::vector<std::vector<uint32_t>> openings_shown_by(const Model& model);

}  // namespace jalon::dxf
