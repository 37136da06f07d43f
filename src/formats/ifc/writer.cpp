// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "formats/face_geometry.h"
#include "formats/files/atomic_file.h"
#include "formats/ifc/bodies.h"
#include "formats/ifc/frame.h"
#include "formats/ifc/ifc.h"
#include "formats/ifc/products.h"
#include "formats/ifc/step_file.h"
#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

using namespace ifc;

constexpr size_t kTicks = 64;  // products between two looks at the task

/// A building, or what stands in none: its storey and what that holds.
struct Place {
  Id spatial = 0, storey = 0, storey_placement = 0;
  std::vector<Id> elements;
};

class IfcFile {
 public:
  IfcFile(const Model& model, double thickness_m, AtomicFile& file)
      : model_(model),
        thickness_m_(thickness_m),
        origin_(whole_metre_corner(model)),
        products_(arrange_products(model)),
        step_(file, "ReferenceView_V1.2", "model.ifc"),
        bodies_(model, origin_, step_),
        ids_(model.parts.size() + 1, 0),
        placements_(model.parts.size() + 1, 0) {}

  void write(Task& task) {
    frame_ = add_frame(step_, model_, origin_);
    add_buildings();
    const size_t count = products_.roles.size();
    // Walls before the openings that void them.
    for (const Role role : {Role::kElement, Role::kOpening})
      for (size_t p = 0; p < count; ++p) {
        if (p % kTicks == 0) task.checkpoint(static_cast<double>(p) / static_cast<double>(count));
        if (products_.roles[p] != role) continue;
        if (role == Role::kElement) add_element(p);
        else add_opening(p);
      }
    add_groups();
    for (const auto& [building, place] : places_) contain(place);
    step_.end();
  }

 private:
  std::string key_of(size_t part, const char* what) const {
    const std::string name = part < model_.parts.size() ? model_.parts[part].name : "";
    return std::string(what) + "/" + std::to_string(part) + "/" + name;
  }
  // ---- buildings ----
  std::string name_of_part(size_t part) const {
    if (part >= model_.parts.size()) return "mesh";
    const Part& p = model_.parts[part];
    return p.name.empty() ? p.part_class : p.name;
  }
  size_t place_of(size_t part) const { return products_.buildings[part]; }

  void add_buildings() {
    std::map<size_t, double> lowest_m;  // of what each holds, from the origin
    for (size_t p = 0; p < products_.roles.size(); ++p) {
      const Role role = products_.roles[p];
      if (role == Role::kNothing || role == Role::kGroup) continue;
      const auto at = lowest_m.emplace(place_of(p), kNaN).first;
      at->second = std::fmin(at->second, lowest_of(products_.shapes[p]));
    }
    std::vector<Id> on_site;
    for (const auto& [part, z_m] : lowest_m) {
      add_building(part, std::isfinite(z_m) ? z_m : 0);
      on_site.push_back(places_[part].spatial);
    }
    aggregate(step_, "buildings of site", frame_.site, on_site);
  }

  // NaN where it has no faces.
  double lowest_of(const Shape& shape) const {
    double z_m = kNaN;
    for (const uint32_t f : shape.faces) {
      const Ring& ring = model_.rings[model_.faces[f].first_ring];
      for (uint64_t i = ring.first; i < ring.first + ring.count; ++i)
        z_m = std::fmin(z_m, model_.vertices[model_.corners[i]].z - origin_.z);
    }
    return z_m;
  }

  void add_building(size_t part, double lowest_m) {
    const bool is_told = part < model_.parts.size();
    Place& place = places_[part];
    const Id placement = add_placement(frame_.site_placement);
    const Id shape = is_told ? add_shape("Body", bodies_.items_of(products_.shapes[part])) : 0;
    const std::string name = is_told ? name_of_part(part) : "building";
    place.spatial = step_.add("IFCBUILDING", root(key_of(part, "building"), name)
                                                 .none()
                                                 .id(placement)
                                                 .id(shape)
                                                 .none()
                                                 .word("ELEMENT")
                                                 .none()
                                                 .none()
                                                 .none());
    if (is_told) ids_[part] = place.spatial, add_properties(part, place.spatial);
    place.storey_placement = add_placement(placement);
    place.storey = step_.add("IFCBUILDINGSTOREY", root(key_of(part, "storey"), "ground")
                                                      .none()
                                                      .id(place.storey_placement)
                                                      .none()
                                                      .none()
                                                      .word("ELEMENT")
                                                      .real(lowest_m));
    aggregate(step_, key_of(part, "storey of building"), place.spatial, {place.storey});
  }

  void contain(const Place& place) {
    if (place.elements.empty()) return;
    step_.add(
        "IFCRELCONTAINEDINSPATIALSTRUCTURE",
        root("contents/" + std::to_string(place.storey), "").ids(place.elements).id(place.storey));
  }

  // ---- products ----
  Id add_placement(Id relative_to) {
    return step_.add("IFCLOCALPLACEMENT", Values().id(relative_to).id(frame_.axes));
  }

  Id add_shape(const char* identifier, const std::vector<Id>& items) {
    if (items.empty()) return 0;
    const Id representation =
        step_.add("IFCSHAPEREPRESENTATION",
                  Values().id(frame_.body).text(identifier).text("Tessellation").ids(items));
    return step_.add("IFCPRODUCTDEFINITIONSHAPE",
                     Values().none().none().ids(std::array{representation}));
  }

  std::string_view class_of(size_t part) const {
    return part < model_.parts.size() ? std::string_view(model_.parts[part].part_class) : "mesh";
  }

  // An element of the part's class; relative_to: the placement of what it stands in.
  Id add_product(size_t part, Id relative_to, const std::vector<Id>& items, const char* what) {
    const Entity entity = entity_of(class_of(part));
    const bool has_measures =
        std::string_view(entity.name) == "IFCWINDOW" || std::string_view(entity.name) == "IFCDOOR";
    placements_[part] = add_placement(relative_to);
    Values values = root(key_of(part, what), name_of_part(part)).text(class_of(part));
    values.id(placements_[part]).id(add_shape("Body", items)).none();
    if (has_measures) {
      // A measure is positive.
      const auto measure = [&](double value_m) {
        value_m > 0 ? values.real(value_m) : values.none();
      };
      measure(model_.parts[part].height_m);
      measure(model_.parts[part].width_m);
    }
    values.word(entity.type);
    if (has_measures) values.none().none();
    const Id id = step_.add(entity.name, values);
    add_properties(part, id);
    return id;
  }

  void add_element(size_t part) {
    Place& place = places_.at(place_of(part));
    const Shape& shape = products_.shapes[part];
    const bool is_solid = thickness_m_ > 0 && class_of(part) == part_class::kWall;
    const auto items = is_solid ? bodies_.walls_of(shape, thickness_m_) : bodies_.items_of(shape);
    ids_[part] = add_product(part, place.storey_placement, items, "element");
    place.elements.push_back(ids_[part]);
  }

  void add_opening(size_t part) {
    const uint32_t host = products_.hosts[part];
    const bool has_host =
        host < ids_.size() && ids_[host] != 0 && products_.roles[host] == Role::kElement;
    Place& place = places_.at(place_of(part));
    const bool is_recess = class_of(part) == part_class::kRecess;
    const auto& holes = products_.holes[part];
    const bool cuts = thickness_m_ > 0 && has_host && class_of(host) == part_class::kWall;
    // "Reference": the wall's own shape has the hole already, nothing is to be cut.
    const Id shape = cuts ? add_shape("Body", bodies_.cuts_of(holes, thickness_m_))
                          : add_shape("Reference", bodies_.outlines_of(holes));
    Id relative_to = place.storey_placement;
    if (has_host) {
      relative_to = add_placement(placements_[host]);
      const Id opening =
          step_.add("IFCOPENINGELEMENT", root(key_of(part, "opening"), name_of_part(part))
                                             .text(class_of(part))
                                             .id(relative_to)
                                             .id(shape)
                                             .none()
                                             .word(is_recess ? "RECESS" : "OPENING"));
      step_.add("IFCRELVOIDSELEMENT", root(key_of(part, "void"), "").id(ids_[host]).id(opening));
      ids_[part] = opening;
    }
    const bool is_product = std::string_view(entity_of(class_of(part)).type) != "USERDEFINED";
    if (!is_product && products_.shapes[part].empty()) {
      if (has_host) add_properties(part, ids_[part]);  // nothing stands in it
      return;
    }
    const Id filling =
        add_product(part, relative_to, bodies_.items_of(products_.shapes[part]), "filling");
    place.elements.push_back(filling);
    if (has_host)
      step_.add("IFCRELFILLSELEMENT", root(key_of(part, "fill"), "").id(ids_[part]).id(filling));
  }

  void add_groups() {
    const auto is_group = [&](size_t p) {
      return products_.roles[p] == Role::kGroup && !products_.members[p].empty();
    };
    for (size_t p = 0; p < model_.parts.size(); ++p)
      if (is_group(p)) {
        ids_[p] =
            step_.add("IFCGROUP", root(key_of(p, "group"), name_of_part(p)).text(class_of(p)));
        add_properties(p, ids_[p]);
      }
    for (size_t p = 0; p < model_.parts.size(); ++p) {
      if (!is_group(p)) continue;
      std::vector<Id> members;
      for (const uint32_t m : products_.members[p])
        if (ids_[m] != 0) members.push_back(ids_[m]);
      if (!members.empty())
        step_.add("IFCRELASSIGNSTOGROUP",
                  root(key_of(p, "members"), "").ids(members).none().id(ids_[p]));
    }
  }

  // ---- what is known of a part ----
  void add_properties(size_t index, Id object) {
    if (index >= model_.parts.size()) return;
    const Part& part = model_.parts[index];
    const Shape& shape = products_.shapes[index];
    double area_m2 = 0, sigma_m = 0, volume_m3 = 0;
    const auto count = [&](const Face& face) {
      if (face.part != index) return;  // what stands in an opening tells its own in other formats
      area_m2 += face.area_m2;
      sigma_m = std::max(sigma_m, face.sigma_m);
    };
    for (const uint32_t f : shape.faces) count(model_.faces[f]);
    for (const uint32_t s : shape.solids) volume_m3 += bodies_.volume_m3(s);
    std::vector<Id> properties;
    const auto add = [&](const char* name, const char* type, const Values& value) {
      if (value.str() == "$") return;
      properties.push_back(step_.add("IFCPROPERTYSINGLEVALUE",
                                     Values().text(name).none().typed(type, value).none()));
    };
    add("Class", "IFCLABEL", Values().text(part.part_class));
    if (part.evidence != Evidence::kNone)
      add("Evidence", "IFCLABEL", Values().text(name_of(part.evidence)));
    add("ClassConfidence", "IFCREAL", Values().real(part.class_confidence));
    if (part.copied_from < model_.parts.size())
      add("CopiedFrom", "IFCLABEL", Values().text(model_.parts[part.copied_from].name));
    add("Width", "IFCLENGTHMEASURE", Values().real(part.width_m));
    add("Height", "IFCLENGTHMEASURE", Values().real(part.height_m));
    add("Depth", "IFCLENGTHMEASURE", Values().real(part.depth_m));
    if (sigma_m > 0) add("SigmaPlane", "IFCLENGTHMEASURE", Values().real(sigma_m));
    define(index, object, "IFCPROPERTYSET", "Jalon_Precision", Values(), properties);
    std::vector<Id> quantities;
    if (area_m2 > 0)
      quantities.push_back(step_.add(
          "IFCQUANTITYAREA", Values().text("NetSurfaceArea").none().none().real(area_m2).none()));
    if (volume_m3 > 0)
      quantities.push_back(step_.add(
          "IFCQUANTITYVOLUME", Values().text("GrossVolume").none().none().real(volume_m3).none()));
    if (!quantities.empty())
      define(index, object, "IFCELEMENTQUANTITY", "Jalon_Measured", Values().none(), quantities);
  }

  void define(size_t part, Id object, const char* entity, const char* name, const Values& between,
              const std::vector<Id>& members) {
    Values values = root(key_of(part, entity), name);
    if (!between.empty()) values.none();
    const Id set = step_.add(entity, values.ids(members));
    step_.add("IFCRELDEFINESBYPROPERTIES",
              root(key_of(part, entity) + "/relation", "").ids(std::array{object}).id(set));
  }

  const Model& model_;
  double thickness_m_;
  Vec3 origin_;
  Products products_;
  StepFile step_;
  Bodies bodies_;
  std::vector<Id> ids_, placements_;  // of each part, once written
  std::map<size_t, Place> places_;    // by building; kNoPart: what stands in none
  Frame frame_;
};

}  // namespace

void write_ifc(const Model& model, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing IFC");
  validate(model);
  AtomicFile file(path);
  const double thickness_m = settings.ifc_wall_thickness_m;
  if (has_arcs(model))
    IfcFile(with_chords(model, settings.chord_error_m), thickness_m, file).write(task);
  else IfcFile(model, thickness_m, file).write(task);
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
