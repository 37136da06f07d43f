// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/sections.h"

// What a drawing of AutoCAD 2000 must have besides its entities: classes, the blocks of model and paper space, and the
// tree of dictionaries with a layout for each space (DXF Reference, OBJECTS section).
namespace jalon::dxf {

namespace {

struct DictionaryEntry {
  const char* name;
  Handle handle;
};

void begin_dictionary(Text& text, const char* kind, Handle own, Handle owner,
                      const std::vector<DictionaryEntry>& entries) {
  text.begin(kind, own, owner).group(100, "AcDbDictionary").group(281, 1);
  for (const DictionaryEntry& entry : entries) text.group(3, entry.name).handle(350, entry.handle);
}

void add_block(Text& text, const char* name, Handle own, Handle end, Handle record, bool paper) {
  text.begin("BLOCK", own, record).group(100, "AcDbEntity");
  if (paper) text.group(67, 1);
  text.group(8, "0").group(100, "AcDbBlockBegin").group(2, name).group(70, 0).point(10, {0, 0, 0});
  text.group(3, name).group(1, "");
  text.begin("ENDBLK", end, record).group(100, "AcDbEntity");
  if (paper) text.group(67, 1);
  text.group(8, "0").group(100, "AcDbBlockEnd");
}

void add_layout(Text& text, const char* name, Handle own, Handle record, int tab, const Box3& box) {
  constexpr int kModelType = 1024, kFitPaper = 16;
  const bool model = tab == 0;
  text.begin("LAYOUT", own, kLayoutDictionary);
  text.group(100, "AcDbPlotSettings")
      .group(1, "")
      .group(2, "none_device")
      .group(4, "A4")
      .group(6, "");
  for (const int code : {40, 41, 42, 43}) text.group(code, 10.0);  // margins (mm)
  text.group(44, 297.0).group(45, 210.0);
  for (const int code : {46, 47, 48, 49, 140, 141}) text.group(code, 0.0);
  text.group(142, 1.0)
      .group(143, 1.0)
      .group(70, model ? kModelType + kFitPaper : kFitPaper)
      .group(72, 1)
      .group(73, 0);
  text.group(74, 0).group(7, "").group(75, 16).group(147, 1.0).group(148, 0.0).group(149, 0.0);
  text.group(100, "AcDbLayout").group(1, name).group(70, 1).group(71, tab);
  text.group(10, 0.0).group(20, 0.0).group(11, 420.0).group(21, 297.0).point(12, {0, 0, 0});
  text.point(14, box.min).point(15, box.max).group(146, 0.0);
  text.point(13, {0, 0, 0})
      .point(16, {1, 0, 0})
      .point(17, {0, 1, 0})
      .group(76, 0)
      .handle(330, record);
}

void add_line_style(Text& text) {
  text.begin("MLINESTYLE", kLineStyleStandard, kLineStyleDictionary).group(100, "AcDbMlineStyle");
  text.group(2, "Standard")
      .group(70, 0)
      .group(3, "")
      .group(62, 256)
      .group(51, 90.0)
      .group(52, 90.0)
      .group(71, 2);
  for (const double offset : {0.5, -0.5}) text.group(49, offset).group(62, 256).group(6, "ByLayer");
}

// The dictionary of the pictures' definitions, these, and what joins each to its entity.
void add_images(Text& text, const Drawing& drawing) {
  constexpr int kReactorVersion = 2, kLoaded = 1, kNoUnits = 0;
  if (drawing.images.empty()) return;
  text.begin("DICTIONARY", kImageDictionary, kRootDictionary)
      .group(100, "AcDbDictionary")
      .group(281, 1);
  for (size_t i = 0; i < drawing.images.size(); ++i)
    text.group(3, "orthoimage_" + std::to_string(i + 1))
        .handle(350, image_handles(drawing, i).definition);
  for (size_t i = 0; i < drawing.images.size(); ++i) {
    const LinkedImage& image = drawing.images[i];
    const ImageHandles handles = image_handles(drawing, i);
    text.group(0, "IMAGEDEF").handle(5, handles.definition);
    text.group(102, "{ACAD_REACTORS")
        .handle(330, kImageDictionary)
        .handle(330, handles.reactor)
        .group(102, "}");
    text.handle(330, kImageDictionary).group(100, "AcDbRasterImageDef").group(90, 0);
    text.group(1, image.link).group(10, double(image.columns)).group(20, double(image.rows));
    const double pixel_m = norm(image.right);
    text.group(11, pixel_m).group(21, pixel_m).group(280, kLoaded).group(281, kNoUnits);
    text.begin("IMAGEDEF_REACTOR", handles.reactor, handles.entity)
        .group(100, "AcDbRasterImageDefReactor")
        .group(90, kReactorVersion)
        .handle(330, handles.entity);
  }
}

}  // namespace

void add_classes(Text& text, const Drawing& drawing) {
  struct Class {
    const char *record, *name, *application;
    int is_entity = 0;
  };
  constexpr Class kClasses[] = {
      {"ACDBDICTIONARYWDFLT", "AcDbDictionaryWithDefault", "ObjectDBX Classes"},
      {"ACDBPLACEHOLDER", "AcDbPlaceHolder", "ObjectDBX Classes"},
      {"LAYOUT", "AcDbLayout", "ObjectDBX Classes"},
  };
  constexpr Class kImageClasses[] = {
      {"IMAGE", "AcDbRasterImage", "ISM", 1},
      {"IMAGEDEF", "AcDbRasterImageDef", "ISM"},
      {"IMAGEDEF_REACTOR", "AcDbRasterImageDefReactor", "ISM"},
  };
  std::vector<Class> classes(std::begin(kClasses), std::end(kClasses));
  if (!drawing.images.empty())
    classes.insert(classes.end(), std::begin(kImageClasses), std::end(kImageClasses));
  text.group(0, "SECTION").group(2, "CLASSES");
  for (const Class& c : classes)
    text.group(0, "CLASS")
        .group(1, c.record)
        .group(2, c.name)
        .group(3, c.application)
        .group(90, 0)
        .group(280, 0)
        .group(281, c.is_entity);
  text.group(0, "ENDSEC");
}

void add_blocks(Text& text) {
  text.group(0, "SECTION").group(2, "BLOCKS");
  if (!text.is_r12()) {
    add_block(text, "*Model_Space", kModelBlock, kModelBlockEnd, kModelSpace, false);
    add_block(text, "*Paper_Space", kPaperBlock, kPaperBlockEnd, kPaperSpace, true);
  }
  text.group(0, "ENDSEC");
}

void add_objects(Text& text, const Drawing& drawing) {
  Box3 box = drawing.box;
  if (box.empty()) box.add({0, 0, 0});
  Box3 sheet;
  sheet.add({0, 0, 0});
  sheet.add({420, 297, 0});
  text.group(0, "SECTION").group(2, "OBJECTS");
  std::vector<DictionaryEntry> entries{{"ACAD_GROUP", kGroupDictionary}};
  if (!drawing.images.empty()) entries.push_back({"ACAD_IMAGE_DICT", kImageDictionary});
  entries.insert(entries.end(), {{"ACAD_LAYOUT", kLayoutDictionary},
                                 {"ACAD_MLINESTYLE", kLineStyleDictionary},
                                 {"ACAD_PLOTSTYLENAME", kPlotStyleDictionary}});
  begin_dictionary(text, "DICTIONARY", kRootDictionary, Handle{}, entries);
  begin_dictionary(text, "DICTIONARY", kGroupDictionary, kRootDictionary, {});
  begin_dictionary(text, "DICTIONARY", kLayoutDictionary, kRootDictionary,
                   {{"Model", kModelLayout}, {"Layout1", kPaperLayout}});
  begin_dictionary(text, "DICTIONARY", kLineStyleDictionary, kRootDictionary,
                   {{"Standard", kLineStyleStandard}});
  begin_dictionary(text, "ACDBDICTIONARYWDFLT", kPlotStyleDictionary, kRootDictionary,
                   {{"Normal", kPlotStyleNormal}});
  text.group(100, "AcDbDictionaryWithDefault").handle(340, kPlotStyleNormal);
  text.begin("ACDBPLACEHOLDER", kPlotStyleNormal, kPlotStyleDictionary);
  add_line_style(text);
  add_images(text, drawing);
  add_layout(text, "Model", kModelLayout, kModelSpace, 0, box);
  add_layout(text, "Layout1", kPaperLayout, kPaperSpace, 1, sheet);
  text.group(0, "ENDSEC");
}

}  // namespace jalon::dxf
