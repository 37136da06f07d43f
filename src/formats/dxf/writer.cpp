// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "formats/dxf/drawing.h"
#include "formats/dxf/dxf.h"
#include "formats/dxf/sections.h"
#include "formats/files/atomic_file.h"

namespace jalon {

namespace {

using namespace dxf;

constexpr size_t kPieceBytes = size_t{1} << 20;  // of text, before it goes to the file
constexpr size_t kTicks = 256;                   // entities between two looks at the task

uint64_t handles_before_entities(const Drawing& drawing) {
  return kFirstFree + drawing.layers.all().size() + 3 * drawing.images.size();
}

/// The first handle behind those of the entities, or one beyond: a polyline takes one for itself, each vertex and its
/// end.
uint64_t handles_end(const Drawing& drawing) {
  uint64_t end =
      handles_before_entities(drawing) + drawing.labels.size() + drawing.triangles.size();
  for (const Polyline& line : drawing.polylines) end += line.corners.size() + 2;
  return end;
}

void write_entities(AtomicFile& file, const Drawing& drawing, const Model& model, Version version,
                    Task& task) {
  Text text(version);
  text.group(0, "SECTION").group(2, "ENTITIES");
  const std::vector<Layer>& layers = drawing.layers.all();
  const size_t lines = drawing.polylines.size(), total = lines + drawing.triangles.size();
  uint64_t next_handle = handles_before_entities(drawing);
  for (size_t i = 0; i < drawing.images.size(); ++i) add_image(text, drawing, i);
  for (size_t i = 0; i < total; ++i) {
    if (i % kTicks == 0) task.checkpoint(static_cast<double>(i) / static_cast<double>(total));
    if (i < lines) {
      add_polyline(text, drawing.polylines[i], layers[drawing.polylines[i].layer], model,
                   next_handle);
    } else {
      std::array<Vec3, 3> corners;
      for (size_t k = 0; k < 3; ++k) corners[k] = model.vertices[drawing.triangles[i - lines][k]];
      add_triangle(text, corners, layers[drawing.triangle_layers[i - lines]], next_handle);
    }
    if (text.size() >= kPieceBytes) file.write(text.take());
  }
  for (const Label& label : drawing.labels)
    add_label(text, label, layers[label.layer], next_handle);
  text.group(0, "ENDSEC");
  file.write(text.take());
}

void write_drawing(const Drawing& drawing, const Model& model, const std::string& path,
                   Version version, Task& task) {
  AtomicFile file(path);
  Text text(version);
  add_header(text, drawing, handles_end(drawing));
  if (!text.is_r12()) add_classes(text, drawing);
  add_tables(text, drawing);
  add_blocks(text);
  file.write(text.take());
  write_entities(file, drawing, model, version, task);
  if (!text.is_r12()) add_objects(text, drawing);
  text.group(0, "EOF");
  file.write(text.take());
  task.checkpoint(1);
  file.commit();
}

// Each section on a layer of its own, in the colours that CAD programs tell apart, one after the other.
Drawing draw_sections(const Sections& sections, Version version) {
  constexpr int kColours = 6;  // red ... magenta
  Drawing drawing;
  for (size_t s = 0; s < sections.sections.size(); ++s) {
    const Section& section = sections.sections[s];
    const uint32_t layer = drawing.layers.named(
        sections.name(s), static_cast<int>(s % static_cast<size_t>(kColours)) + 1, version);
    for (const SectionLine& line : section.lines) {
      Polyline drawn;
      for (const Vec2& p : line.vertices) {
        drawn.corners.push_back(section.plane.place(p));
        drawing.box.add(drawn.corners.back());
      }
      drawn.normal = section.plane.normal;
      drawn.layer = layer;
      drawn.is_closed = line.is_closed;
      drawn.is_ring = false;
      drawing.polylines.push_back(std::move(drawn));
    }
    drawing.view_direction = section.plane.normal;
  }
  return drawing;
}

}  // namespace

void write_dxf(const Sections& sections, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing DXF");
  write_drawing(draw_sections(sections, settings.dxf_version), Model{}, path, settings.dxf_version,
                task);
}

void write_dxf(const Model& model, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing DXF");
  validate(model);
  const Version version = settings.dxf_version;
  const bool in_space = settings.dxf_view == DxfView::kWorld;
  Drawing drawing =
      in_space ? draw_world(model, task) : draw_elevation(model, settings.chord_error_m, task);
  if (!settings.dxf_images.empty()) {
    if (version == Version::kR12)
      fail(Status::kUnsupported, "%.400s: drawings of release 12 show no images", path.c_str());
    drawing.images = linked_images(settings.dxf_images, path, model, in_space);
    drawing.image_layer = drawing.layers.of_class("orthoimage");
  }
  write_drawing(drawing, model, path, version, task);
}

}  // namespace jalon
