// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/clearance.h"

#include "capi/support/gauge_pieces.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "compare/clearance/clearance.h"

using namespace jalon;
using namespace jalon::capi;

static_assert(JALON_WHOLE_MODEL == kWholeModel && JALON_WHOLE_MODEL == kNoRow);

namespace {

/// Two tables, each only if wanted.
struct TablePair {
  Owned<jalon_fields> first = own<jalon_fields>(nullptr), second = own<jalon_fields>(nullptr);

  void make(jalon_fields** a, FieldTable table_a, jalon_fields** b, FieldTable table_b) {
    if (a != nullptr) first = own(new_fields(std::move(table_a)));
    if (b != nullptr) second = own(new_fields(std::move(table_b)));
  }
  void hand_out(jalon_fields** a, jalon_fields** b) {
    if (a != nullptr) *a = first.release();
    if (b != nullptr) *b = second.release();
  }
};

ClearanceSettings settings_of_of_clearance(const jalon_params* options) {
  return settings_from<ClearanceSettings>(options_or_default(options, "clearance"));
}

// gauge() may take a while: it belongs to the task.
template <class Gauge>
void sweep(Gauge&& gauge, const std::vector<Transform>& poses, const jalon_cloud* cloud,
           const jalon_model* model, const ClearanceSettings& settings, jalon_task* task,
           jalon_fields** places, jalon_fields** intervals) {
  if (cloud == nullptr && model == nullptr)
    fail(Status::kInvalidArgument, "cloud and model are both NULL");
  TablePair tables;
  with_task(task, [&](Task& t) {
    const std::vector<ConvexPiece> pieces = gauge();
    SweepTables made = sweep_tables(pieces, poses, cloud != nullptr ? cloud->cloud.get() : nullptr,
                                    model != nullptr ? model->model.get() : nullptr, settings, t);
    tables.make(places, std::move(made.places), intervals, std::move(made.intervals));
  });
  tables.hand_out(places, intervals);
}

}  // namespace

jalon_status jalon_model_clearance(const jalon_model* model, uint64_t part,
                                   const jalon_cloud* cloud, const jalon_params* options,
                                   jalon_task* task, jalon_fields** summary,
                                   jalon_fields** near_points) {
  return guard([&] {
    require(model, "model");
    require(cloud, "cloud");
    const ClearanceSettings settings = settings_of_of_clearance(options);
    TablePair tables;
    with_task(task, [&](Task& t) {
      ClearanceTables made = clearance_to_cloud(*model->model, part, *cloud->cloud, settings, t);
      tables.make(summary, std::move(made.summary), near_points, std::move(made.near));
    });
    tables.hand_out(summary, near_points);
  });
}

jalon_status jalon_model_clearance_to_model(const jalon_model* model, uint64_t part,
                                            const jalon_model* other, uint64_t other_part,
                                            const jalon_params* options, jalon_task* task,
                                            jalon_fields** summary, jalon_fields** near_faces) {
  return guard([&] {
    require(model, "model");
    require(other, "other");
    const ClearanceSettings settings = settings_of_of_clearance(options);
    TablePair tables;
    with_task(task, [&](Task& t) {
      ClearanceTables made =
          clearance_to_model(*model->model, part, *other->model, other_part, settings, t);
      tables.make(summary, std::move(made.summary), near_faces, std::move(made.near));
    });
    tables.hand_out(summary, near_faces);
  });
}

jalon_status jalon_gauge_sweep(const jalon_gauge_piece* pieces, uint64_t piece_count,
                               const double* hull_points, uint64_t hull_point_count,
                               const jalon_transform* poses, uint64_t pose_count,
                               const jalon_cloud* cloud, const jalon_model* model,
                               const jalon_params* options, jalon_task* task, jalon_fields** places,
                               jalon_fields** intervals) {
  return guard([&] {
    const ClearanceSettings settings = settings_of_of_clearance(options);
    const std::vector<ConvexPiece> gauge =
        gauge_of(pieces, piece_count, hull_points, hull_point_count);
    const std::vector<Transform> list = pose_list(poses, pose_count);
    sweep([&] { return gauge; }, list, cloud, model, settings, task, places, intervals);
  });
}

jalon_status jalon_gauge_sweep_model(const jalon_model* gauge, const jalon_transform* poses,
                                     uint64_t pose_count, const jalon_cloud* cloud,
                                     const jalon_model* model, const jalon_params* options,
                                     jalon_task* task, jalon_fields** places,
                                     jalon_fields** intervals) {
  return guard([&] {
    require(gauge, "gauge");
    const ClearanceSettings settings = settings_of_of_clearance(options);
    const std::vector<Transform> list = pose_list(poses, pose_count);
    sweep([&] { return gauge_of_model(*gauge->model, settings.chord_m); }, list, cloud, model,
          settings, task, places, intervals);
  });
}
