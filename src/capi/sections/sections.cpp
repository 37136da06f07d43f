// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/sections.h"

#include "capi/support/guard.h"
#include "capi/support/section_handles.h"
#include "formats/dxf/dxf.h"
#include "formats/settings.h"
#include "report/pictures/section_drawing.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

bool ends_with(const std::string& path, const char* end) {
  std::string lower = path.substr(path.size() - std::min<size_t>(path.size(), 4));
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower == end;
}

}  // namespace

jalon_status jalon_cloud_sections(const jalon_cloud* cloud, const double* alignment,
                                  uint64_t alignment_count, const jalon_params* options,
                                  jalon_task* task, jalon_sections** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    if (alignment_count > 0)
      require_array(alignment, JALON_FLOAT64, alignment_count, 3, 0, "alignment");
    std::vector<Vec3> axis;
    for (uint64_t i = 0; i < alignment_count; ++i)
      axis.push_back({alignment[3 * i], alignment[3 * i + 1], alignment[3 * i + 2]});
    const ParamSet values = options_or_default(options, "sections");
    const auto settings = settings_from<SectionSettings>(values);
    const CloudPtr points = cloud->cloud;
    *out = with_task(task, [&](Task& t) {
             auto handle = std::make_unique<jalon_sections>();
             handle->parameters = values.to_json();
             handle->sections = cut_sections(*points, axis, settings, t);
             for (size_t s = 0; s < handle->sections.sections.size(); ++s)
               handle->names.push_back(handle->sections.name(s));
             return own(handle.release());
           }).release();
  });
}

jalon_sections* jalon_sections_retain(jalon_sections* sections) { return retain(sections); }
void jalon_sections_release(jalon_sections* sections) { release(sections); }

jalon_status jalon_sections_summary(const jalon_sections* sections, jalon_fields** out) {
  return give_fields(sections, "sections", out, [&] { return section_table(sections->sections); });
}
jalon_status jalon_sections_lines(const jalon_sections* sections, jalon_fields** out) {
  return give_fields(sections, "sections", out,
                     [&] { return section_line_table(sections->sections); });
}
jalon_status jalon_sections_vertices(const jalon_sections* sections, jalon_fields** out) {
  return give_fields(sections, "sections", out,
                     [&] { return section_vertex_table(sections->sections); });
}

jalon_status jalon_sections_name(const jalon_sections* sections, uint64_t i, const char** out) {
  return guard([&] {
    require(sections, "sections");
    require(out, "out");
    if (i >= sections->names.size())
      fail(Status::kInvalidArgument, "section %llu of %llu", static_cast<unsigned long long>(i),
           static_cast<unsigned long long>(sections->names.size()));
    *out = sections->names[i].c_str();
  });
}

jalon_status jalon_sections_parameters(const jalon_sections* sections, const char** out) {
  return guard([&] {
    require(sections, "sections");
    require(out, "out");
    *out = sections->parameters.c_str();
  });
}

jalon_status jalon_sections_write(const jalon_sections* sections, const char* path,
                                  const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(sections, "sections");
    const std::string name = require_text(path, "path");
    const auto settings = settings_from<WriteSettings>(options_or_default(options, "write"));
    const bool drawing = ends_with(name, ".svg");
    if (!drawing && !ends_with(name, ".dxf"))
      fail(Status::kUnsupported, "%s: sections are written as .dxf or .svg", name.c_str());
    with_task(task, [&](Task& t) {
      if (drawing) write_section_drawing(sections->sections, name, t);
      else write_dxf(sections->sections, name, settings, t);
    });
  });
}
