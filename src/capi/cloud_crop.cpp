// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "base/text_number.h"
#include "capi/support/cloud_handle.h"

namespace jalon::capi {

CloudPair split_by_mask(const Cloud& cloud, std::span<const uint8_t> mask, bool want_ones,
                        bool want_zeros, Task& task) {
  CloudPair pair;
  {
    ProgressSpan span(task, 0, want_zeros ? 0.5 : 1);
    if (want_ones) pair.first.reset(new_cloud(select_mask(cloud, mask, 1, task)));
  }
  ProgressSpan span(task, want_ones ? 0.5 : 0, 1);
  if (want_zeros) pair.second.reset(new_cloud(select_mask(cloud, mask, 0, task)));
  return pair;
}

namespace {

/// make(task) gives the mask; then both parts. The shape of all functions below.
template <class F>
void split(const jalon_cloud* cloud, jalon_task* task, jalon_cloud** ones, jalon_cloud** zeros,
           F&& make) {
  CloudPair pair = with_task(task, [&](Task& t) {
    std::vector<uint8_t> mask;
    {
      ProgressSpan span(t, 0, 0.5);
      mask = make(t);
    }
    ProgressSpan span(t, 0.5, 1, "copying");
    return split_by_mask(*cloud->cloud, mask, ones != nullptr, zeros != nullptr, t);
  });
  pair.hand_out(ones, zeros);
}

Transform from_c_or_identity(const jalon_transform* t) {
  return t == nullptr ? Transform() : from_c(*t);
}

void require_finite_vec(const jalon_vec3& v, const char* name) {
  if (!is_finite(from_c(v)))
    fail(Status::kInvalidArgument, "%s holds a value that is not finite", name);
}

void require_interval(double low, double high, const char* what) {
  if (std::isnan(low) || std::isnan(high) || low > high)
    fail(Status::kInvalidArgument, "%s: the smallest value %s is above the largest %s", what,
         text_of(low).c_str(), text_of(high).c_str());
}

std::vector<Vec2> require_polygon(const double* uv, uint64_t count) {
  constexpr uint64_t kMaxCorners = 1000000;
  require(uv, "polygon_uv");
  if (count < 3 || count > kMaxCorners)
    fail(Status::kInvalidArgument, "a polygon of %llu corners; 3 ... 1000000 are possible",
         static_cast<unsigned long long>(count));
  std::vector<Vec2> polygon(count);
  for (size_t i = 0; i < count; ++i) {
    polygon[i] = {uv[2 * i], uv[2 * i + 1]};
    if (!std::isfinite(polygon[i].u) || !std::isfinite(polygon[i].v))
      fail(Status::kInvalidArgument, "corner %llu of the polygon is not finite",
           static_cast<unsigned long long>(i));
  }
  return polygon;
}

std::vector<uint8_t> where_equal(const Column& column, double value, Task& task) {
  constexpr size_t kGrain = 1 << 16;
  std::vector<uint8_t> mask(column.count());
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    const auto values = column.values<T>();
    parallel_for(task, values.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) mask[i] = static_cast<double>(values[i]) == value;
    });
  });
  return mask;
}

}  // namespace

}  // namespace jalon::capi

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_cloud_select(const jalon_cloud* cloud, const uint64_t* indices, uint64_t count,
                                jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    require_array(indices, JALON_UINT64, count, 1, 0, "indices");
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(select(*cloud->cloud, {indices, count}, t)));
           }).release();
  });
}

jalon_status jalon_cloud_split(const jalon_cloud* cloud, const char* field, double value,
                               jalon_task* task, jalon_cloud** equal, jalon_cloud** others) {
  return guard([&] {
    require(cloud, "cloud");
    const Column& column = cloud->cloud->fields.require(require_text(field, "field"));
    if (column.info().components != 1)
      fail(Status::kInvalidArgument, "field \"%s\" has %u components; a split needs one",
           column.info().name.c_str(), column.info().components);
    if (std::isnan(value)) fail(Status::kInvalidArgument, "value is NaN, which equals nothing");
    split(cloud, task, equal, others, [&](Task& t) { return where_equal(column, value, t); });
  });
}

jalon_status jalon_cloud_append(const jalon_cloud* a, const jalon_cloud* b, jalon_task* task,
                                jalon_cloud** out) {
  return guard([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(append(*a->cloud, *b->cloud, t)));
           }).release();
  });
}

jalon_status jalon_cloud_transform(const jalon_cloud* cloud, const jalon_transform* transform,
                                   jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(transform, "transform");
    require(out, "out");
    const Transform map = from_c(*transform);
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(transformed(*cloud->cloud, map, t)));
           }).release();
  });
}

jalon_status jalon_cloud_crop_box(const jalon_cloud* cloud, const jalon_box* box,
                                  const jalon_transform* T_box_world, jalon_task* task,
                                  jalon_cloud** inside, jalon_cloud** outside) {
  return guard([&] {
    require(cloud, "cloud");
    require(box, "box");
    const Box3 region{from_c(box->min), from_c(box->max)};
    for (int i = 0; i < 3; ++i) require_interval(region.min[i], region.max[i], "box");
    const Transform map = from_c_or_identity(T_box_world);
    split(cloud, task, inside, outside,
          [&](Task& t) { return inside_box(*cloud->cloud, region, map, t); });
  });
}

jalon_status jalon_cloud_crop_polygon(const jalon_cloud* cloud, const double* polygon_uv,
                                      uint64_t count, double w_min, double w_max,
                                      const jalon_transform* T_prism_world, jalon_task* task,
                                      jalon_cloud** inside, jalon_cloud** outside) {
  return guard([&] {
    require(cloud, "cloud");
    const std::vector<Vec2> polygon = require_polygon(polygon_uv, count);
    require_interval(w_min, w_max, "w");
    const Transform map = from_c_or_identity(T_prism_world);
    split(cloud, task, inside, outside,
          [&](Task& t) { return inside_prism(*cloud->cloud, polygon, w_min, w_max, map, t); });
  });
}

jalon_status jalon_cloud_crop_cylinder(const jalon_cloud* cloud, const jalon_vec3* foot,
                                       const jalon_vec3* top, double radius_m, jalon_task* task,
                                       jalon_cloud** inside, jalon_cloud** outside) {
  return guard([&] {
    require(cloud, "cloud");
    require(foot, "foot");
    require(top, "top");
    require_finite_vec(*foot, "foot");
    require_finite_vec(*top, "top");
    split(cloud, task, inside, outside, [&](Task& t) {
      return inside_cylinder(*cloud->cloud, from_c(*foot), from_c(*top), radius_m, t);
    });
  });
}

jalon_status jalon_cloud_split_interest(const jalon_cloud* cloud, const jalon_params* options,
                                        jalon_task* task, jalon_cloud** interest,
                                        jalon_cloud** unwanted) {
  return guard([&] {
    require(cloud, "cloud");
    const auto chosen = settings_from<InterestSettings>(options_or_default(options, "interest"));
    split(cloud, task, interest, unwanted,
          [&](Task& t) { return points_of_interest(*cloud->cloud, chosen, t); });
  });
}
