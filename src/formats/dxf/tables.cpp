// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "formats/dxf/sections.h"

namespace jalon::dxf {

namespace {

constexpr int kUnitMetre = 6;  // of $INSUNITS

Box3 box_of(const Drawing& drawing) {
  Box3 box = drawing.box;
  if (box.empty()) box.add({0, 0, 0});
  return box;
}

void begin_section(Text& text, const char* name) { text.group(0, "SECTION").group(2, name); }
void end_section(Text& text) { text.group(0, "ENDSEC"); }

void begin_table(Text& text, const char* name, Handle handle, size_t entries) {
  text.group(0, "TABLE").group(2, name);
  if (!text.is_r12()) text.handle(5, handle).handle(330, 0).group(100, "AcDbSymbolTable");
  text.group(70, static_cast<int>(entries));
}
void end_table(Text& text) { text.group(0, "ENDTAB"); }

void begin_entry(Text& text, const char* table, Handle handle, Handle owner, const char* subclass,
                 const char* name) {
  text.begin(table, handle, owner)
      .subclass("AcDbSymbolTableRecord")
      .subclass(subclass)
      .group(2, name)
      .group(70, 0);
}

// The window that the drawing opens in: looks at the middle of all, from the front.
void add_viewport(Text& text, const Drawing& drawing) {
  const Box3 box = box_of(drawing);
  const Vec3 size = box.max - box.min;
  const double height_m = std::max(1.0, 1.1 * norm(size));
  begin_table(text, "VPORT", kViewportTable, 1);
  begin_entry(text, "VPORT", kViewportActive, kViewportTable, "AcDbViewportTableRecord", "*ACTIVE");
  const auto pair = [&](int code, double x, double y) { text.group(code, x).group(code + 10, y); };
  pair(10, 0, 0);
  pair(11, 1, 1);
  pair(12, 0, 0);
  pair(13, 0, 0);
  pair(14, 1, 1);
  pair(15, 1, 1);
  text.point(16, drawing.view_direction).point(17, box.min + 0.5 * size);
  text.group(40, height_m)
      .group(41, 1.5)
      .group(42, 50.0)
      .group(43, 0.0)
      .group(44, 0.0)
      .group(50, 0.0)
      .group(51, 0.0);
  text.group(71, 0)
      .group(72, 1000)
      .group(73, 1)
      .group(74, 3)
      .group(75, 0)
      .group(76, 0)
      .group(77, 0)
      .group(78, 0);
  end_table(text);
}

void add_linetype(Text& text, Handle handle, const char* name, const char* description,
                  std::initializer_list<double> dashes_m) {
  begin_entry(text, "LTYPE", handle, kLinetypeTable, "AcDbLinetypeTableRecord", name);
  double length = 0;
  for (const double dash : dashes_m) length += std::fabs(dash);
  text.group(3, description)
      .group(72, 65)
      .group(73, static_cast<int>(dashes_m.size()))
      .group(40, length);
  for (const double dash : dashes_m) {
    text.group(49, dash);
    if (!text.is_r12()) text.group(74, 0);
  }
}

void add_linetypes(Text& text) {
  begin_table(text, "LTYPE", kLinetypeTable, text.is_r12() ? 2 : 4);
  if (!text.is_r12()) {
    add_linetype(text, kLinetypeByBlock, "ByBlock", "", {});
    add_linetype(text, kLinetypeByLayer, "ByLayer", "", {});
  }
  add_linetype(text, kLinetypeContinuous, text.is_r12() ? "CONTINUOUS" : "Continuous", "Solid line",
               {});
  add_linetype(text, kLinetypeDashed, "DASHED", "Copied elements and areas without data __ __ __",
               {0.1, -0.05});
  end_table(text);
}

void add_layers(Text& text, const Drawing& drawing) {
  const std::vector<Layer>& layers = drawing.layers.all();
  begin_table(text, "LAYER", kLayerTable, layers.size());
  uint64_t handle = kFirstFree;
  for (const Layer& layer : layers) {
    begin_entry(text, "LAYER", static_cast<Handle>(handle++), kLayerTable, "AcDbLayerTableRecord",
                layer.name.c_str());
    const char* continuous = text.is_r12() ? "CONTINUOUS" : "Continuous";
    text.group(62, layer.colour).group(6, layer.dashed ? "DASHED" : continuous);
    if (!text.is_r12()) text.group(370, -3).handle(390, kPlotStyleNormal);
  }
  end_table(text);
}

void add_styles(Text& text) {
  begin_table(text, "STYLE", kStyleTable, 1);
  const char* name = text.is_r12() ? "STANDARD" : "Standard";
  begin_entry(text, "STYLE", kStyleStandard, kStyleTable, "AcDbTextStyleTableRecord", name);
  text.group(40, 0.0)
      .group(41, 1.0)
      .group(50, 0.0)
      .group(71, 0)
      .group(42, 0.2)
      .group(3, "txt")
      .group(4, "");
  end_table(text);
}

void add_applications(Text& text) {
  begin_table(text, "APPID", kAppIdTable, 2);
  begin_entry(text, "APPID", kAppIdAcad, kAppIdTable, "AcDbRegAppTableRecord", "ACAD");
  begin_entry(text, "APPID", kAppIdJalon, kAppIdTable, "AcDbRegAppTableRecord", "JALON");
  end_table(text);
}

// The only entries with their handle in group 105.
void add_dimension_styles(Text& text) {
  begin_table(text, "DIMSTYLE", kDimStyleTable, 1);
  text.group(100, "AcDbDimStyleTable").group(71, 0);
  text.begin("DIMSTYLE", kDimStyleStandard, kDimStyleTable, 105);
  text.group(100, "AcDbSymbolTableRecord")
      .group(100, "AcDbDimStyleTableRecord")
      .group(2, "Standard")
      .group(70, 0);
  text.handle(340, kStyleStandard);
  end_table(text);
}

void add_block_records(Text& text) {
  const auto record = [&](Handle handle, const char* name, Handle layout) {
    text.begin("BLOCK_RECORD", handle, kBlockRecordTable).group(100, "AcDbSymbolTableRecord");
    text.group(100, "AcDbBlockTableRecord").group(2, name).handle(340, layout);
  };
  begin_table(text, "BLOCK_RECORD", kBlockRecordTable, 2);
  record(kModelSpace, "*Model_Space", kModelLayout);
  record(kPaperSpace, "*Paper_Space", kPaperLayout);
  end_table(text);
}

}  // namespace

void add_header(Text& text, const Drawing& drawing, uint64_t handles_end) {
  const Box3 box = box_of(drawing);
  begin_section(text, "HEADER");
  const auto variable = [&](const char* name) -> Text& { return text.group(9, name); };
  variable("$ACADVER").group(1, text.is_r12() ? "AC1009" : "AC1015");
  if (!text.is_r12()) variable("$DWGCODEPAGE").group(3, "ANSI_1252");
  variable("$INSBASE").point(10, {0, 0, 0});
  variable("$EXTMIN").point(10, box.min);
  variable("$EXTMAX").point(10, box.max);
  variable("$LIMMIN").group(10, box.min.x).group(20, box.min.y);
  variable("$LIMMAX").group(10, box.max.x).group(20, box.max.y);
  variable("$LTSCALE").group(40, 1.0);
  variable("$LUNITS").group(70, 2);
  variable("$LUPREC").group(70, 4);
  variable("$CLAYER").group(8, "0");
  if (!text.is_r12()) {
    variable("$HANDSEED").handle(5, handles_end);
    variable("$MEASUREMENT").group(70, 1);
    variable("$INSUNITS").group(70, kUnitMetre);
  }
  end_section(text);
}

void add_tables(Text& text, const Drawing& drawing) {
  begin_section(text, "TABLES");
  add_viewport(text, drawing);
  add_linetypes(text);
  add_layers(text, drawing);
  add_styles(text);
  begin_table(text, "VIEW", kViewTable, 0);
  end_table(text);
  begin_table(text, "UCS", kUcsTable, 0);
  end_table(text);
  add_applications(text);
  if (!text.is_r12()) {
    add_dimension_styles(text);
    add_block_records(text);
  }
  end_section(text);
}

}  // namespace jalon::dxf
