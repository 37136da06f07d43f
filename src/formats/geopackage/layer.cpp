// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/layer.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace jalon::gpkg {

namespace {

// A day before GeoPackage: equal models give equal files.
constexpr char kLastChange[] = "1970-01-01T00:00:00.000Z";

}  // namespace

void add_layer_lists(Database& database) {
  // OGC 12-128r17, annex C.
  database.run(
      "CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, "
      "identifier TEXT UNIQUE, description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT "
      "(strftime('%Y-%m-%dT%H:%M:%fZ','now')), min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y "
      "DOUBLE, srs_id INTEGER, CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES "
      "gpkg_spatial_ref_sys(srs_id));"
      "CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, "
      "geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT "
      "NOT NULL, CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT "
      "uk_gc_table_name UNIQUE (table_name), CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) "
      "REFERENCES gpkg_contents(table_name), CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES "
      "gpkg_spatial_ref_sys (srs_id))");
}

Layer::Layer(Database& database, const LayerInfo& info, int32_t srs_id)
    : database_(database), info_(info), srs_id_(srs_id) {
  const std::string name = info.name;
  database_.run("CREATE TABLE " + name + " (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom " +
                info.geometry + ", " + info.columns + ")");
  std::string marks = "NULL, ?, ?";
  for (auto n = std::ranges::count(info.columns, ','); n > 0; --n) marks += ", ?";
  rows_.emplace(database_, "INSERT INTO " + name + " VALUES (" + marks + ")");
}

void Layer::count(const Line& line) {
  for (const Vec3& p : line) box_.add(p);
}

void Layer::add_row(std::string bytes, std::span<const Value> values) {
  std::vector<Value> row{Blob{std::move(bytes)}};
  row.insert(row.end(), values.begin(), values.end());
  rows_->add(row);
}

void Layer::add(const Line& line, std::span<const Value> values) {
  count(line);
  add_row(line_bytes(line, srs_id_), values);
}

void Layer::add(const Polygon& polygon, std::span<const Value> values) {
  count(polygon.front());
  add_row(polygon_bytes(polygon, srs_id_), values);
}

void Layer::add(const std::vector<Polygon>& polygons, std::span<const Value> values) {
  for (const Polygon& polygon : polygons) count(polygon.front());
  add_row(polygons_bytes(polygons, srs_id_), values);
}

void Layer::end() {
  rows_.reset();
  const std::string name = info_.name;
  const auto side = [&](double value) { return box_.empty() ? Value() : Value(value); };
  Insertion contents(database_,
                     "INSERT INTO gpkg_contents VALUES (?, 'features', ?, ?, ?, ?, ?, ?, ?, ?)");
  contents.add(std::array<Value, 9>{name, name, std::string(info_.description),
                                    std::string(kLastChange), side(box_.min.x), side(box_.min.y),
                                    side(box_.max.x), side(box_.max.y), int64_t{srs_id_}});
  Insertion geometries(database_,
                       "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 1, 0)");
  geometries.add(std::array<Value, 3>{name, std::string(info_.geometry), int64_t{srs_id_}});
}

}  // namespace jalon::gpkg
