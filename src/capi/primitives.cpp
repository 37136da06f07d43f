// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/primitives.h"

#include "capi/support/guard.h"
#include "capi/support/worker_handles.h"
#include "formats/files/atomic_file.h"
#include "segment/picks/picks.h"
#include "segment/result/tables.h"
#include "segment/surface/primitive_fits.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

constexpr uint64_t kMaxPicks = 4096;  // made by hand

std::span<const uint64_t> index_list(const uint64_t* indices, uint64_t count) {
  if (count == 0) return {};
  require_array(indices, JALON_UINT64, count, 1, 0, "indices");
  return {indices, static_cast<size_t>(count)};
}

FieldTable one_row(const Segment& segment) {
  Segmentation table;
  table.segments.push_back(segment);
  return segment_table(table);
}

std::vector<Vec3> pick_list(const double* picks, uint64_t count) {
  if (count > kMaxPicks)
    fail(Status::kInvalidArgument, "%llu picks; at most %llu",
         static_cast<unsigned long long>(count), static_cast<unsigned long long>(kMaxPicks));
  require(picks, "picks");
  std::vector<Vec3> out;
  for (uint64_t i = 0; i < count; ++i) {
    out.push_back({picks[3 * i], picks[3 * i + 1], picks[3 * i + 2]});
    if (!is_finite(out.back()))
      fail(Status::kInvalidArgument, "pick %llu is not finite", static_cast<unsigned long long>(i));
  }
  return out;
}

jalon_segmentation* new_segmentation(Segmentation segmentation) {
  auto handle = std::make_unique<jalon_segmentation>();
  handle->segmentation = std::make_shared<const Segmentation>(std::move(segmentation));
  return handle.release();
}

}  // namespace

jalon_status jalon_cloud_fit_sphere(const jalon_cloud* cloud, const uint64_t* indices,
                                    uint64_t count, const jalon_params* options, jalon_task* task,
                                    jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen =
        settings_from<PrimitiveFitSettings>(options_or_default(options, "primitive"));
    const auto list = index_list(indices, count);
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(one_row(sphere_segment(*cloud->cloud, list, chosen, t))));
           }).release();
  });
}

jalon_status jalon_cloud_fit_cylinder(const jalon_cloud* cloud, const uint64_t* indices,
                                      uint64_t count, const jalon_vec3* direction,
                                      const jalon_params* options, jalon_task* task,
                                      jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen =
        settings_from<PrimitiveFitSettings>(options_or_default(options, "primitive"));
    const auto list = index_list(indices, count);
    const Vec3 axis = direction != nullptr ? from_c(*direction) : Vec3{};
    if (!is_finite(axis)) fail(Status::kInvalidArgument, "the direction of the axis is not finite");
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(one_row(cylinder_segment(
                 *cloud->cloud, list, direction != nullptr ? &axis : nullptr, chosen, t))));
           }).release();
  });
}

jalon_status jalon_cloud_fit_circle(const jalon_cloud* cloud, const uint64_t* indices,
                                    uint64_t count, const jalon_params* options, jalon_task* task,
                                    jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen =
        settings_from<PrimitiveFitSettings>(options_or_default(options, "primitive"));
    const auto list = index_list(indices, count);
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(circle_table(*cloud->cloud, list, chosen, t)));
           }).release();
  });
}

jalon_status jalon_segmentation_start(const jalon_cloud* cloud, jalon_task* task,
                                      jalon_segmentation** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             return own(new_segmentation(empty_segmentation(cloud->cloud, t)));
           }).release();
  });
}

jalon_status jalon_segmentation_pick(const jalon_segmentation* segmentation, int32_t primitive,
                                     const double* picks, uint64_t count,
                                     const jalon_params* options, jalon_task* task,
                                     jalon_segmentation** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    if (primitive < JALON_PRIMITIVE_PLANE || primitive > JALON_PRIMITIVE_CYLINDER)
      fail(Status::kInvalidArgument, "%d is no primitive: 1 plane, 2 sphere, 3 cylinder",
           primitive);
    const auto chosen = settings_from<PickSettings>(options_or_default(options, "pick"));
    const std::vector<Vec3> list = pick_list(picks, count);
    *out = with_task(task, [&](Task& t) {
             return own(new_segmentation(with_pick(*segmentation->segmentation,
                                                   static_cast<PrimitiveType>(primitive), list,
                                                   chosen, t)));
           }).release();
  });
}

jalon_status jalon_segmentation_remaining(const jalon_segmentation* segmentation, jalon_task* task,
                                          jalon_cloud** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(remaining_points(*segmentation->segmentation, t)));
           }).release();
  });
}

jalon_status jalon_segmentation_write_primitives(const jalon_segmentation* segmentation,
                                                 const char* path) {
  return guard([&] {
    require(segmentation, "segmentation");
    AtomicFile file(require_text(path, "path"));
    file.write(primitive_text(*segmentation->segmentation));
    file.commit();
  });
}
