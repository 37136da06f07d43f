// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/dxf/dxf.h"
#include "formats/dxf/group_reader.h"
#include "formats/dxf/model_builder.h"
#include "formats/dxf/placing.h"
#include "formats/files/utf8.h"
#include "formats/units/file_unit.h"

namespace jalon {

namespace {

using namespace dxf;

constexpr size_t kEntityTicks = 1024;  // entities between two looks at the task

// Header variable $INSUNITS: metres a unit; 0 for those that say nothing (0: without unit) or are not used on earth.
double metres_of_insunits(int64_t code) {
  switch (code) {
    case 1:
      return 0.0254;
    case 2:
      return 0.3048;
    case 4:
      return 0.001;
    case 5:
      return 0.01;
    case 6:
      return 1;
    case 10:
      return 0.9144;
    case 14:
      return 0.1;
    case 21:
      return 1200.0 / 3937.0;
    default:
      return 0;
  }
}

class DxfReader {
 public:
  DxfReader(const ByteSource& source, const ReadSettings& settings, Task& task)
      : source_(source), settings_(settings), task_(task), groups_(source) {}

  Model run() {
    refuse_binary();
    bool has_entities = false;
    while (groups_.next()) {
      if (groups_.is(0, "EOF")) break;
      if (!groups_.is(0, "SECTION"))
        groups_.refuse("a SECTION was expected, not \"%.40s\"",
                       std::string(groups_.value()).c_str());
      if (!groups_.next() || groups_.code() != 2) groups_.refuse("a SECTION has no name");
      const std::string name(groups_.value());
      if (name == "HEADER") read_header();
      else if (name == "BLOCKS") read_blocks();
      else if (name == "ENTITIES") read_entities(shapes_, "ENDSEC"), has_entities = true;
      else skip_section();
    }
    if (!has_entities) groups_.refuse("there is no section ENTITIES");
    return model();
  }

 private:
  void refuse_binary() const {
    char first[22] = {};
    const size_t got = source_.read_some(0, first, sizeof first - 1);
    const std::string_view start(first, got);
    if (start.starts_with("AutoCAD Binary DXF"))
      fail(Status::kUnsupported, "%.400s: a binary DXF file; save it as text",
           source_.path().c_str());
    if (start.starts_with("AC10"))
      fail(Status::kUnsupported, "%.400s: a DWG drawing; save it as DXF", source_.path().c_str());
  }

  void skip_section() {
    while (groups_.next())
      if (groups_.is(0, "ENDSEC")) return;
    groups_.refuse("the file ends within a section");
  }

  void read_header() {
    bool is_unit = false;
    while (groups_.next()) {
      if (groups_.is(0, "ENDSEC")) return;
      if (groups_.code() == 9) is_unit = groups_.value() == "$INSUNITS";
      else if (is_unit && groups_.code() == 70) insunits_ = groups_.integer(), is_unit = false;
    }
    groups_.refuse("the file ends within a section");
  }

  // Until the entity of this name.
  void read_entities(Shapes& shapes, const char* end) {
    size_t count = 0;
    while (groups_.next()) {
      if (groups_.code() != 0)
        groups_.refuse("an entity was expected, not group %d", groups_.code());
      if (groups_.value() == end) return;
      if (count++ % kEntityTicks == 0) task_.checkpoint(0.9 * groups_.fraction());
      read_entity(groups_, shapes);
    }
    groups_.refuse("the file ends before %s", end);
  }

  void read_blocks() {
    while (groups_.next()) {
      if (groups_.is(0, "ENDSEC")) return;
      if (!groups_.is(0, "BLOCK")) continue;  // the groups of ENDBLK
      Shapes block;
      std::string name;
      while (groups_.next() && groups_.code() != 0) {
        if (groups_.code() == 2) name = groups_.text();
        for (const int k : {0, 1, 2})
          if (groups_.code() == 10 * (k + 1)) block.base[k] = groups_.number();
      }
      groups_.put_back();
      read_entities(block, "ENDBLK");
      // The layouts themselves stand in ENTITIES.
      if (!lower(name).starts_with("*model_space") && !lower(name).starts_with("*paper_space"))
        blocks_.emplace(lower(name), std::move(block));
    }
    groups_.refuse("the file ends within a section");
  }

  double metres_a_unit() const {
    if (settings_.unit != FileUnit::kAuto) return metres_of(settings_.unit);
    const double told = metres_of_insunits(insunits_);
    if (told != 0 && told != 1)
      task_.log(Task::kInfo, "DXF: a unit of the drawing is %s m", text_of(told).c_str());
    return told != 0 ? told : 1;
  }

  Model model() {
    ModelBuilder builder(settings_.polygons, metres_a_unit());
    std::map<std::string, size_t> missing;
    const Taker taker{[&](Loop loop) { builder.add(std::move(loop)); },
                      [&](Patch patch) { builder.add(std::move(patch)); },
                      [&](const std::string& block) { ++missing[block]; }};
    place(shapes_, blocks_, taker, {source_.path(), source_.size()}, task_);
    std::map<std::string, size_t> left_out = shapes_.left_out;
    for (const auto& [name, block] : blocks_)
      for (const auto& [entity, count] : block.left_out) left_out[entity] += count;
    std::string text;
    for (const auto& [entity, count] : left_out)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + entity;
    if (!text.empty())
      task_.log(Task::kWarning, "DXF: left out, no surfaces: %.400s", text.c_str());
    for (const auto& [block, count] : missing)
      task_.log(Task::kWarning, "DXF: block \"%.100s\", inserted %zu times, is not there",
                block.c_str(), count);
    Model model = builder.take();
    for (const Vec3& p : model.vertices)
      if (!is_finite(p))
        fail(Status::kFormat, "%.400s: a corner is not finite in metres, where its blocks place it",
             source_.path().c_str());
    if (model.faces.empty() && model.triangles.empty())
      fail(Status::kFormat, "%.400s: no closed polyline, 3DFACE or mesh%s%.200s",
           source_.path().c_str(), text.empty() ? "" : "; there are: ", text.c_str());
    return model;
  }

  const ByteSource& source_;
  const ReadSettings& settings_;
  Task& task_;
  GroupReader groups_;
  Shapes shapes_;
  Blocks blocks_;
  int64_t insunits_ = 0;
};

}  // namespace

Model read_dxf(const ByteSource& source, const ReadSettings& settings, Task& task) {
  ProgressSpan span(task, 0, 0.99, "reading DXF");
  Model model = DxfReader(source, settings, task).run();
  validate(model);
  return model;
}

}  // namespace jalon
