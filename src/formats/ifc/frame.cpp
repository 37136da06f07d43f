// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/frame.h"

#include <array>

#include "formats/units/crs_code.h"

namespace jalon::ifc {

namespace {

constexpr double kPrecision_m = 1e-6;  // below it corners are one, as the context tells

Id add_unit(StepFile& file, const char* quantity, const char* name) {
  return file.add("IFCSIUNIT", Values().derived().word(quantity).none().word(name));
}

Id add_axes(StepFile& file, const Vec3& place) {
  const Id point = file.add("IFCCARTESIANPOINT", Values().point(place));
  return file.add("IFCAXIS2PLACEMENT3D", Values().id(point).none().none());
}

void add_map_conversion(StepFile& file, uint32_t epsg_code, const Vec3& origin, Id context,
                        Id metre) {
  const Id crs = file.add("IFCPROJECTEDCRS", Values()
                                                 .text("EPSG:" + std::to_string(epsg_code))
                                                 .none()
                                                 .none()
                                                 .none()
                                                 .none()
                                                 .none()
                                                 .id(metre));
  file.add("IFCMAPCONVERSION", Values()
                                   .id(context)
                                   .id(crs)
                                   .real(origin.x)
                                   .real(origin.y)
                                   .real(origin.z)
                                   .real(1)
                                   .real(0)
                                   .real(1));
}

}  // namespace

Values root(const std::string& key, const std::string& name) {
  Values values = Values().text(guid_of(key)).none();
  return (name.empty() ? values.none() : values.text(name)).none();
}

void aggregate(StepFile& file, const std::string& key, Id whole, const std::vector<Id>& parts) {
  if (!parts.empty()) file.add("IFCRELAGGREGATES", root(key, "").id(whole).ids(parts));
}

Frame add_frame(StepFile& file, const Model& model, const Vec3& origin) {
  Frame frame;
  const std::array units{
      add_unit(file, "LENGTHUNIT", "METRE"), add_unit(file, "AREAUNIT", "SQUARE_METRE"),
      add_unit(file, "VOLUMEUNIT", "CUBIC_METRE"), add_unit(file, "PLANEANGLEUNIT", "RADIAN")};
  const Id assignment = file.add("IFCUNITASSIGNMENT", Values().ids(units));
  frame.axes = add_axes(file, {});
  const Id context =
      file.add("IFCGEOMETRICREPRESENTATIONCONTEXT",
               Values().none().text("Model").integer(3).real(kPrecision_m).id(frame.axes).none());
  Values body = Values().text("Body").text("Model");
  body.derived().derived().derived().derived().id(context).none().word("MODEL_VIEW").none();
  frame.body = file.add("IFCGEOMETRICREPRESENTATIONSUBCONTEXT", body);
  const uint32_t code = metric_epsg_code(model.crs.str());
  if (code != 0) add_map_conversion(file, code, origin, context, units[0]);
  const Id project = file.add(
      "IFCPROJECT",
      root("project", "project").none().none().none().ids(std::array{context}).id(assignment));
  frame.site_placement = file.add(
      "IFCLOCALPLACEMENT", Values().none().id(code != 0 ? frame.axes : add_axes(file, origin)));
  Values site = root("site", "site").none().id(frame.site_placement).none().none();
  site.word("ELEMENT").none().none().none().none().none();
  frame.site = file.add("IFCSITE", site);
  aggregate(file, "site of project", project, {frame.site});
  return frame;
}

}  // namespace jalon::ifc
