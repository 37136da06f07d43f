// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/atomic_file.h"
#include "formats/dxf_drawing.h"
#include "formats/dxf_sections.h"
#include "formats/readers.h"

namespace jalon {

namespace {

using namespace dxf;

constexpr size_t kPieceBytes = size_t{1} << 20;  // of text, before it goes to the file
constexpr size_t kTicks = 256;                   // entities between two looks at the task

uint64_t handles_before_entities(const Drawing& drawing) { return kFirstFree + drawing.layers.all().size(); }

/// How many handles the entities take: as add_polyline and add_triangle give them out.
class Entities {
 public:
  Entities(const Drawing& drawing, const Model& model, Version version)
      : drawing_(drawing), model_(model), text_(version), next_handle_(handles_before_entities(drawing)) {}

  template <class Put>
  uint64_t write(Put&& put, Task& task) {
    text_.group(0, "SECTION").group(2, "ENTITIES");
    const std::vector<Layer>& layers = drawing_.layers.all();
    const size_t lines = drawing_.polylines.size(), total = lines + drawing_.triangles.size();
    for (size_t i = 0; i < total; ++i) {
      if (i % kTicks == 0) task.checkpoint(static_cast<double>(i) / static_cast<double>(total));
      if (i < lines) {
        add_polyline(text_, drawing_.polylines[i], layers[drawing_.polylines[i].layer], model_, next_handle_);
      } else {
        std::array<Vec3, 3> corners;
        for (size_t k = 0; k < 3; ++k) corners[k] = model_.vertices[drawing_.triangles[i - lines][k]];
        add_triangle(text_, corners, layers[drawing_.triangle_layers[i - lines]], next_handle_);
      }
      if (text_.size() >= kPieceBytes) put(text_.take());
    }
    text_.group(0, "ENDSEC");
    put(text_.take());
    return next_handle_;
  }

 private:
  const Drawing& drawing_;
  const Model& model_;
  Text text_;
  uint64_t next_handle_;
};

}  // namespace

void write_dxf(const Model& model, const std::string& path, const ParamSet& options, Task& task) {
  Span span(task, 0, 0.99, "writing DXF");
  validate(model);
  const Version version = options.text("dxf_version") == "r12" ? Version::kR12 : Version::kR2000;
  const Drawing drawing = options.text("dxf_view") == "elevation"
                              ? draw_elevation(model, options.number("chord_error_m"), task)
                              : draw_world(model, task);
  // The header tells the first free handle: at most three an entity and corner, so it stands before them.
  uint64_t handles_end = handles_before_entities(drawing) + drawing.triangles.size();
  for (const Polyline& line : drawing.polylines) handles_end += line.corners.size() + 2;
  AtomicFile file(path);
  Text text(version);
  add_header(text, drawing, handles_end);
  if (!text.is_r12()) add_classes(text);
  add_tables(text, drawing);
  add_blocks(text);
  file.write(text.take());
  Entities(drawing, model, version).write([&](const std::string& piece) { file.write(piece); }, task);
  if (!text.is_r12()) add_objects(text, drawing);
  text.group(0, "EOF");
  file.write(text.take());
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
