// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "formats/geopackage/geometry.h"
#include "formats/geopackage/sqlite_database.h"

namespace jalon::gpkg {

/// What a layer is; its table has the columns "fid" and "geom" before these.
struct LayerInfo {
  const char* name;
  const char* geometry;  ///< POLYGON, LINESTRING or MULTIPOLYGON, all with z
  const char* description;
  std::string columns;  ///< names and types, separated by commas
};

/// The tables that list layers and their geometries.
void add_layer_lists(Database& database);

/// A table of features. Rows are numbered from 1 in the order in which they come.
class Layer {
 public:
  Layer(Database& database, const LayerInfo& info, int32_t srs_id);

  void add(const Line& line, std::span<const Value> values);
  void add(const Polygon& polygon, std::span<const Value> values);
  void add(const std::vector<Polygon>& polygons, std::span<const Value> values);
  /// Lists the layer with the box of what it has. No rows may follow.
  void end();

 private:
  void add_row(std::string bytes, std::span<const Value> values);
  void count(const Line& line);
  Database& database_;
  LayerInfo info_;
  int32_t srs_id_;
  std::optional<Insertion> rows_;
  Box3 box_;
};

}  // namespace jalon::gpkg
