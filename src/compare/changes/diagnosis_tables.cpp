// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/table_columns.h"
#include "compare/changes/diagnosis.h"

namespace jalon {

namespace {

struct Row {
  const Diagnosis* diagnosis;
  const Change* change;
  uint32_t number;
  bool is_displacement() const {
    return change->change_class == ChangeClass::kDisplacement ||
           change->change_class == ChangeClass::kDisplacementOverlap;
  }
};

std::vector<Row> rows_of(const Diagnosis& diagnosis) {
  std::vector<Row> rows;
  for (const Change& change : diagnosis.changes)
    rows.push_back({&diagnosis, &change, static_cast<uint32_t>(rows.size() + 1)});
  return rows;
}

Vec3 centroid(const Epoch& epoch, const std::vector<uint32_t>& indices) {
  if (indices.empty()) return {std::nan(""), std::nan(""), std::nan("")};
  Vec3 sum;
  for (const uint32_t i : indices) sum += epoch.local(i);
  return epoch.origin + sum / static_cast<double>(indices.size());
}

Box3 box_of(const Row& row) {
  Box3 box;
  for (const uint32_t i : row.change->object.before)
    box.add(row.diagnosis->before.cloud().point(i));
  for (const uint32_t i : row.change->object.after) box.add(row.diagnosis->after.cloud().point(i));
  return box;
}

void add_vectors(FieldTable& table, const std::vector<Row>& rows, const char* name,
                 const char* unit, const char* meaning, auto&& of) {
  add_columns<double, 3>(table, rows, name, unit, meaning, [&](const Row& row, double* out) {
    const Vec3 v = of(row);
    for (int k = 0; k < 3; ++k) out[k] = v[k];
  });
}

void add_motion(FieldTable& table, const std::vector<Row>& rows) {
  const Vec3 none{std::nan(""), std::nan(""), std::nan("")};
  add_vectors(
      table, rows, "displacement", "m", "of the object's centroid before",
      [&](const Row& r) { return r.is_displacement() ? r.change->match.displacement : none; });
  add_vectors(table, rows, "rotation", "rad", "rotation vector",
              [&](const Row& r) { return r.is_displacement() ? r.change->match.rotation : none; });
  add_columns<double, 36>(table, rows, "covariance", "", "of rotation (rad) and displacement (m)",
                          [](const Row& r, double* out) {
                            for (size_t k = 0; k < 36; ++k)
                              out[k] = r.is_displacement() ? r.change->match.covariance[k]
                                                           : std::nan("");
                          });
}

}  // namespace

std::span<const ParamRow> diagnosis_rows() { return regions_rows(); }

FieldTable diagnosis_points_table(const Diagnosis& diagnosis, bool is_after) {
  const Epoch& epoch = is_after ? diagnosis.after : diagnosis.before;
  FieldTable table = region_points_table(epoch.regions);
  std::vector<uint32_t> change(epoch.regions.labels.size(), 0);
  for (const Row& row : rows_of(diagnosis))
    for (const uint32_t i : is_after ? row.change->object.after : row.change->object.before)
      change[i] = row.number;
  table.set(make_column<uint32_t>(
      {"change", ElementType::kUint32, 1, "",
       "row of the changes table, unchanged parts of the object too; 0 = none"},
      change));
  return table;
}

FieldTable changes_table(const Diagnosis& diagnosis) {
  FieldTable table;
  const std::vector<Row> rows = rows_of(diagnosis);
  const Epoch &before = diagnosis.before, &after = diagnosis.after;
  add_column<uint32_t>(table, rows, "change", "", "number", [](const Row& r) { return r.number; });
  add_column<uint8_t>(table, rows, "class", "", "1 appearance ... 6 deformation with overlap",
                      [](const Row& r) { return r.change->change_class; });
  add_column<double>(table, rows, "confidence", "", "0 ... 1",
                     [](const Row& r) { return r.change->confidence; });
  add_column<uint64_t>(table, rows, "points_before", "", "of the object",
                       [](const Row& r) { return r.change->object.before.size(); });
  add_column<uint64_t>(table, rows, "points_after", "", "of the object",
                       [](const Row& r) { return r.change->object.after.size(); });
  add_column<double>(table, rows, "area_before", "m2", "of its changed surface", [&](const Row& r) {
    return changed_area(before, r.change->object.regions_before);
  });
  add_column<double>(table, rows, "area_after", "m2", "of its changed surface", [&](const Row& r) {
    return changed_area(after, r.change->object.regions_after);
  });
  add_column<double>(
      table, rows, "volume_before", "m3", "between its changed surface and the other epoch",
      [&](const Row& r) { return changed_volume(before, r.change->object.regions_before); });
  add_column<double>(
      table, rows, "volume_after", "m3", "between its changed surface and the other epoch",
      [&](const Row& r) { return changed_volume(after, r.change->object.regions_after); });
  add_vectors(table, rows, "centroid_before", "m", "mean of its points",
              [&](const Row& r) { return centroid(before, r.change->object.before); });
  add_vectors(table, rows, "centroid_after", "m", "mean of its points",
              [&](const Row& r) { return centroid(after, r.change->object.after); });
  add_vectors(table, rows, "box_min", "m", "of both", [](const Row& r) { return box_of(r).min; });
  add_vectors(table, rows, "box_max", "m", "of both", [](const Row& r) { return box_of(r).max; });
  add_motion(table, rows);
  return table;
}

}  // namespace jalon
