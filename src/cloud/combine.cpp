// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "cloud/cloud.h"
#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr size_t kCombineGrain = 1 << 16;
// Below this share of the product of the row lengths a determinant is rounding noise: the map flattens space.
constexpr double kSingular = 1e-12;

unsigned long long number(size_t n) { return n; }

/// One type that holds the values of both.
ElementType common_type(ElementType a, ElementType b) {
  if (a == b) return a;
  if (is_floating(a) || is_floating(b)) return ElementType::kFloat64;
  return ElementType::kInt64;
}

/// Fills the items [first, first + count) with "no value": NaN, or 0 for integers.
void fill_missing(Column& column, size_t first, size_t count) {
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    auto values = column.values<T>().subspan(first * column.info().components,
                                             count * column.info().components);
    // quiet_NaN() of an integer type is 0.
    std::fill(values.begin(), values.end(), std::numeric_limits<T>::quiet_NaN());
  });
}

void place(Column& to, size_t first, const Column* from, size_t count) {
  if (from == nullptr) return fill_missing(to, first, count);
  const FieldInfo& info = from->info();
  store_converted(to, first, from->raw(), info.type, count, size_of(info.type) * info.components);
}

size_t row_bytes(const Column& column) {
  return column.info().components * size_of(column.info().type);
}

ColumnPtr appended_column(const Column* a, size_t count_a, const Column* b, size_t count_b) {
  FieldInfo info = a != nullptr ? a->info() : b->info();
  if (a != nullptr && b != nullptr) {
    if (a->info().components != b->info().components)
      fail(Status::kInvalidArgument,
           "field \"%s\" has %u components in one cloud and %u in the other", info.name.c_str(),
           a->info().components, b->info().components);
    if (a->info().unit != b->info().unit && !a->info().unit.empty() && !b->info().unit.empty())
      fail(Status::kInvalidArgument,
           "field \"%s\" is in \"%s\" in one cloud and in \"%s\" in the other", info.name.c_str(),
           a->info().unit.c_str(), b->info().unit.c_str());
    info.type = common_type(a->info().type, b->info().type);
    if (info.unit.empty()) info.unit = b->info().unit;
    if (info.meaning.empty()) info.meaning = b->info().meaning;
  }
  auto column = std::make_shared<Column>(info, count_a + count_b);
  place(*column, 0, a, count_a);
  place(*column, count_a, b, count_b);
  return column;
}

/// Coordinates, and fields of which each has at least the narrower type of both clouds.
uint64_t appended_bytes(const Cloud& a, const Cloud& b) {
  const uint64_t count = uint64_t{a.size()} + b.size();
  uint64_t row = 3 * sizeof(double);
  for (const ColumnPtr& column : a.fields) row += row_bytes(*column);
  for (const ColumnPtr& column : b.fields)
    if (a.fields.find(column->info().name) == nullptr) row += row_bytes(*column);
  return count * row;
}

void require_invertible(const Transform& t) {
  double lengths = 1;
  for (size_t i = 0; i < 3; ++i) lengths *= norm(Vec3{t.m[4 * i], t.m[4 * i + 1], t.m[4 * i + 2]});
  if (!(std::fabs(t.determinant()) > kSingular * lengths) || !std::isfinite(lengths))
    fail(Status::kInvalidArgument, "the transform is not invertible: its determinant is 0");
}

/// A map that stretches or mirrors makes the scanner's frame no frame any more. Its upright axis keeps its direction,
/// for that is what vertical angles are measured from, and its first axis stays beside it (Gram and Schmidt).
Transform rigid_pose(const Transform& mapped) {
  if (is_rigid(mapped)) return mapped;
  const auto column = [&](size_t j) {
    return normalized({mapped.m[j], mapped.m[4 + j], mapped.m[8 + j]});
  };
  const Vec3 z = column(2), first = column(0), x = normalized(first - z * dot(z, first)),
             y = cross(z, x);
  Transform out = mapped;
  for (int i = 0; i < 3; ++i) {
    double* row = out.m.data() + 4 * i;
    row[0] = x[i];
    row[1] = y[i];
    row[2] = z[i];
  }
  return out;
}

/// Normals go by the inverse transpose, so that they stay square to their surface under any affine map.
ColumnPtr transformed_normals(const Column& column, const Transform& transform, Task& task) {
  const Transform back = inverse(transform);
  auto out = std::make_shared<Column>(column.info(), column.count());
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_floating_point_v<T>) {
      const auto from = column.values<T>();
      const auto to = out->template values<T>();
      parallel_for(task, column.count(), kCombineGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const Vec3 n{double{from[3 * i]}, double{from[3 * i + 1]}, double{from[3 * i + 2]}};
          const auto& m = back.m;
          const Vec3 turned = normalized({m[0] * n.x + m[4] * n.y + m[8] * n.z,
                                          m[1] * n.x + m[5] * n.y + m[9] * n.z,
                                          m[2] * n.x + m[6] * n.y + m[10] * n.z});
          for (int c = 0; c < 3; ++c)
            to[3 * i + static_cast<size_t>(c)] = static_cast<T>(turned[c]);
        }
      });
    }
  });
  return out;
}

}  // namespace

Cloud append(const Cloud& a, const Cloud& b, Task& task) {
  if (!a.crs.empty() && !b.crs.empty() && a.crs != b.crs)
    fail(Status::kInvalidArgument, "the clouds have different coordinate reference systems");
  require_memory(appended_bytes(a, b));
  Buffer<double> xyz(3 * (a.size() + b.size()));
  const auto copy = [&](const Cloud& from, size_t first) {
    parallel_for(task, from.size(), kCombineGrain, [&](size_t begin, size_t end) {
      std::memcpy(xyz.data() + 3 * (first + begin), from.xyz().data() + 3 * begin,
                  (end - begin) * 3 * sizeof(double));
    });
  };
  {
    ProgressSpan span(task, 0, 0.25);
    copy(a, 0);
  }
  {
    ProgressSpan span(task, 0.25, 0.5);
    copy(b, a.size());
  }
  Cloud out = make_cloud(std::move(xyz));
  ProgressSpan span(task, 0.5, 1);
  const double columns = static_cast<double>(a.fields.size() + b.fields.size());
  double done = 0;
  for (const ColumnPtr& column : a.fields) {
    task.checkpoint(done++ / columns);
    out.fields.set(
        appended_column(column.get(), a.size(), b.fields.find(column->info().name), b.size()));
  }
  for (const ColumnPtr& column : b.fields) {
    task.checkpoint(done++ / columns);
    if (a.fields.find(column->info().name) == nullptr)
      out.fields.set(appended_column(nullptr, a.size(), column.get(), b.size()));
  }
  out.stations = a.stations;
  for (Station station : b.stations) {
    station.first += a.size();
    out.stations.push_back(std::move(station));
  }
  out.crs = a.crs.empty() ? b.crs : a.crs;
  out.attachments = a.attachments ? a.attachments : b.attachments;
  return out;
}

Cloud transformed(const Cloud& cloud, const Transform& transform, Task& task) {
  require_invertible(transform);
  const Column* normal = cloud.fields.find("normal");
  if (normal != nullptr && (normal->info().components != 3 || !is_floating(normal->info().type)))
    normal = nullptr;
  require_memory(cloud.size() *
                 (3 * sizeof(double) + (normal != nullptr ? row_bytes(*normal) : 0)));
  Buffer<double> xyz(3 * cloud.size());
  {
    ProgressSpan span(task, 0, 0.7);
    parallel_for(task, cloud.size(), kCombineGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Vec3 p = transform.point(cloud.point(i));
        for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = p[c];
        if (!is_finite(p))
          fail(Status::kInvalidArgument, "the transform moves point %llu to infinity", number(i));
      }
    });
  }
  Cloud out = make_cloud(std::move(xyz));
  ProgressSpan span(task, 0.7, 1);
  out.fields = cloud.fields;
  if (normal != nullptr) out.fields.set(transformed_normals(*normal, transform, task));
  out.stations = cloud.stations;
  for (Station& station : out.stations)
    if (station.has_pose) station.pose = rigid_pose(transform * station.pose);
  out.crs = cloud.crs;
  out.attachments = cloud.attachments;
  return out;
}

}  // namespace jalon
