// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/parallel.h"
#include "formats/ept/data_set.h"
#include "formats/ept/ept.h"
#include "formats/ept/hierarchy.h"
#include "formats/ept/schema.h"
#include "formats/files/told_stations.h"
#include "formats/las/copc_tree.h"
#include "formats/las/copc_writer.h"
#include "formats/las/layout.h"
#include "formats/units/crs_code.h"
#include "formats/units/epsg_wkt.h"
#include "formats/units/length_units.h"

namespace jalon {

namespace {

using namespace ept;

constexpr int kSpan = 1 << las::kCopcGridLevels;   // cells a side of a node's grid
constexpr size_t kStationBytes = size_t{8} << 20;  // of a text, which readers of JSON take at once

void add_box(JsonWriter& json, const char* name, const Vec3& low, const Vec3& high) {
  json.name(name).begin_array();
  for (const Vec3& corner : {low, high})
    for (int k = 0; k < 3; ++k) json.value(corner[k]);
  json.end_array();
}

// Coordinates are metres: a system of another unit would be wrong of them.
void add_crs(JsonWriter& json, const Cloud& cloud, const std::string& path, Task& task) {
  const std::string crs = cloud.crs.str();
  const uint32_t code = metric_epsg_code(crs);
  std::string wkt = code == 0 ? "" : wkt_of_epsg(code);
  if (las::is_wkt(crs) && units_of_crs(crs).metres() && !units_of_crs(crs).degrees) wkt = crs;
  json.name("srs").begin_object();
  if (code != 0)
    json.name("authority").value("EPSG").name("horizontal").value(std::to_string(code));
  if (!wkt.empty()) json.name("wkt").value(wkt);
  json.end_object();
  if (!crs.empty() && wkt.empty())
    task.log(Task::kWarning, "%s: EPT names its CRS by WKT, which is not known in metres of %.60s",
             path.c_str(), crs.c_str());
}

Box3 box_in_file(const Buffer<double>& xyz) {
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  if (xyz.size() == 0) box = {{0, 0, 0}, {0, 0, 0}};
  return box;
}

std::string index_text(const Schema& schema, const las::CopcTree& tree, const Box3& box,
                       const Cloud& cloud, const std::string& path, Task& task) {
  const Vec3 half{tree.halfsize, tree.halfsize, tree.halfsize};
  JsonWriter json(1);
  json.begin_object();
  add_box(json, "bounds", tree.centre - half, tree.centre + half);
  add_box(json, "boundsConforming", box.min, box.max);
  json.name("dataType").value("binary").name("hierarchyType").value("json");
  json.name("points").value(cloud.size()).name("schema");
  add_schema(schema, json, task);
  json.name("span").value(kSpan);
  add_crs(json, cloud, path, task);
  json.name("version").value("1.0.0");
  if (!schema.station.empty()) {
    json.name("jalon").begin_array();
    for (const std::string& text : station_texts(cloud, schema.station, {1, 1, 1}, kStationBytes))
      json.value(read_json(text).front());
    json.end_array();
  }
  return json.end_object().take() + "\n";
}

void write_nodes(const Schema& schema, const las::CopcTree& tree, const Cloud& cloud,
                 const DataSet& set, Task& task) {
  parallel_chunks(task, tree.nodes.size(), [&](size_t n) {
    const las::CopcTree::Node& node = tree.nodes[n];
    std::vector<std::byte> records(node.count * schema.record_bytes);
    put_records(schema, cloud, std::span(tree.order).subspan(node.first, node.count),
                records.data());
    set.write(kDataFolder, name_of(node.key) + ".bin", records.data(), records.size());
  });
}

}  // namespace

void write_ept(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  DataSet set(path);
  Schema schema;
  las::CopcTree tree;
  std::string index;
  {
    ProgressSpan span(task, 0, 0.5, "writing EPT");
    schema = make_schema(cloud, path, settings, task);
    Buffer<double> xyz = las::coordinates_in_file(schema.steps, cloud, task);
    const Box3 box = box_in_file(xyz);
    tree = las::copc_tree(std::move(xyz), task);
    index = index_text(schema, tree, box, cloud, path, task);
  }
  ProgressSpan span(task, 0.5, 0.99, "writing EPT");
  write_nodes(schema, tree, cloud, set, task);
  for (const HierarchyFile& file : hierarchy_files(tree.nodes))
    set.write(kHierarchyFolder, file.name + ".json", file.json.data(), file.json.size());
  task.checkpoint(1);  // the last chance to cancel before the old data set goes
  set.commit(index);
}

}  // namespace jalon
