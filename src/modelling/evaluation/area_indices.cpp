// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/area_indices.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "base/table_columns.h"
#include "modelling/evaluation/index_rows.h"

namespace jalon {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double rate(double part, double whole) { return whole > 0 ? part / whole : kNaN; }

// Excess or deficit against what is shared.
double factor(double wrong, double shared) {
  if (shared > 0) return wrong / shared;
  return wrong > 0 ? kInfinity : kNaN;
}

struct IndexColumn {
  const char* name;
  const char* meaning;
  double AreaIndices::*value;
};
constexpr IndexColumn kIndexColumns[] = {
    {"completeness", "detection rate TP / |SR|", &AreaIndices::completeness},
    {"correctness", "TP / |SA|", &AreaIndices::correctness},
    {"quality", "TP / |SR u SA|", &AreaIndices::quality},
    {"branching", "excess factor; inf: nothing shared", &AreaIndices::branching},
    {"miss", "deficit factor; inf: nothing shared", &AreaIndices::miss},
    {"failure", "FP / |SR|, the false alarm rate", &AreaIndices::failure},
    {"omission", "FN / |SR|", &AreaIndices::omission},
};

}  // namespace

ComparedAreas& ComparedAreas::operator+=(const ComparedAreas& b) {
  automatic_m2 += b.automatic_m2;
  reference_m2 += b.reference_m2;
  intersection_m2 += b.intersection_m2;
  return *this;
}

AreaIndices area_indices(const ComparedAreas& areas, IndexFormulas formulas) {
  const double shared = areas.intersection_m2, excess = areas.excess_m2(),
               deficit = areas.deficit_m2();
  AreaIndices out;
  out.completeness = rate(shared, areas.reference_m2);
  out.correctness = rate(shared, areas.automatic_m2);
  out.quality = rate(shared, areas.union_m2());
  out.branching = factor(excess, shared);
  out.miss = factor(deficit, shared);
  if (formulas == IndexFormulas::kThesis) std::swap(out.branching, out.miss);
  out.failure = rate(excess, areas.reference_m2);
  out.omission = rate(deficit, areas.reference_m2);
  return out;
}

MeanAndStd mean_and_std(std::span<const double> values) {
  double sum = 0, squares = 0;
  size_t n = 0;
  for (const double v : values)
    if (std::isfinite(v)) sum += v, ++n;
  MeanAndStd out;
  if (n == 0) return out;
  out.mean = sum / static_cast<double>(n);
  for (const double v : values)
    if (std::isfinite(v)) squares += (v - out.mean) * (v - out.mean);
  if (n > 1) out.std = std::sqrt(squares / static_cast<double>(n - 1));
  return out;
}

std::span<const ParamRow> indices_rows() { return kIndexRows; }

void require_areas(std::span<const ComparedAreas> rows) {
  for (size_t i = 0; i < rows.size(); ++i) {
    const ComparedAreas& r = rows[i];
    for (const double area : {r.automatic_m2, r.reference_m2, r.intersection_m2})
      if (!(area >= 0) || !std::isfinite(area))
        fail(Status::kInvalidArgument, "row %zu has an area that is negative or not finite", i);
    if (r.intersection_m2 > r.automatic_m2 || r.intersection_m2 > r.reference_m2)
      fail(Status::kInvalidArgument,
           "row %zu: the intersection is larger than one of the two areas", i);
  }
}

FieldTable index_table(std::span<const ComparedAreas> rows, IndexFormulas formulas) {
  FieldTable t;
  using C = ComparedAreas;
  add_column<double>(t, rows, "area_automatic", "m2", "|SA|",
                     [](const C& r) { return r.automatic_m2; });
  add_column<double>(t, rows, "area_reference", "m2", "|SR|",
                     [](const C& r) { return r.reference_m2; });
  add_column<double>(t, rows, "intersection", "m2", "TP: area of both",
                     [](const C& r) { return r.intersection_m2; });
  add_column<double>(t, rows, "excess", "m2", "FP: area of SA alone",
                     [](const C& r) { return r.excess_m2(); });
  add_column<double>(t, rows, "deficit", "m2", "FN: area of SR alone",
                     [](const C& r) { return r.deficit_m2(); });
  for (const IndexColumn& c : kIndexColumns)
    add_column<double>(t, rows, c.name, "1", c.meaning,
                       [&](const C& r) { return area_indices(r, formulas).*c.value; });
  return t;
}

FieldTable index_totals_table(std::span<const ComparedAreas> rows, const ComparedAreas& unpaired,
                              IndexFormulas formulas) {
  FieldTable t;
  ComparedAreas sum = unpaired;
  for (const ComparedAreas& row : rows) sum += row;
  add_value<double>(t, "area_automatic", "m2", "sum of |SA|", sum.automatic_m2);
  add_value<double>(t, "area_reference", "m2", "sum of |SR|", sum.reference_m2);
  add_value<double>(t, "intersection", "m2", "sum of TP", sum.intersection_m2);
  const AreaIndices total = area_indices(sum, formulas);
  for (const IndexColumn& c : kIndexColumns) {
    std::vector<double> values;
    for (const ComparedAreas& row : rows) values.push_back(area_indices(row, formulas).*c.value);
    const MeanAndStd spread = mean_and_std(values);
    const std::string name = c.name;
    add_value<double>(t, "total_" + name, "1", "of the sums", total.*c.value);
    add_value<double>(t, "mean_" + name, "1", "over the rows, finite values", spread.mean);
    add_value<double>(t, "std_" + name, "1", "over the rows, divided by n - 1", spread.std);
  }
  return t;
}

}  // namespace jalon
