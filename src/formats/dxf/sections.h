// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "formats/dxf/drawing.h"
#include "formats/dxf/text.h"

namespace jalon::dxf {

// The sections around ENTITIES. Release 12 has HEADER, TABLES and BLOCKS; 2000 all of them.

/// handles_end: the first handle that is not used.
void add_header(Text& text, const Drawing& drawing, uint64_t handles_end);
void add_classes(Text& text, const Drawing& drawing);
/// Layers take their handles from kFirstFree on, then images three each.
void add_tables(Text& text, const Drawing& drawing);
void add_blocks(Text& text);
void add_objects(Text& text, const Drawing& drawing);

/// The ENTITIES section item by item.
void add_polyline(Text& text, const Polyline& line, const Layer& layer, const Model& model,
                  uint64_t& next_handle);
void add_triangle(Text& text, const std::array<Vec3, 3>& corners, const Layer& layer,
                  uint64_t& next_handle);
void add_label(Text& text, const Label& label, const Layer& layer, uint64_t& next_handle);

/// The handles of an image: the entity, the definition of its file, and what joins both.
struct ImageHandles {
  uint64_t entity, definition, reactor;
};
ImageHandles image_handles(const Drawing& drawing, size_t image);
void add_image(Text& text, const Drawing& drawing, size_t image);

/// Axes of the object coordinate system of a normal (DXF Reference, "Arbitrary Axis Algorithm").
struct ObjectAxes {
  Vec3 x, y, z;
  Vec3 project(const Vec3& p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
};
ObjectAxes object_axes(const Vec3& normal);

}  // namespace jalon::dxf
