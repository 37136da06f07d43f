// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/clearance.h"

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "compare/clearance/clearance.h"
#include "geometry/rigid_motion.h"
#include "solid/motion.h"

using namespace jalon;
using namespace jalon::capi;

static_assert(JALON_WHOLE_MODEL == kWholeModel && JALON_WHOLE_MODEL == kNoRow);

namespace {

constexpr uint64_t kMaxPieces = 1000;
constexpr uint64_t kMaxPoses = 10'000'000;
constexpr double kLargest_m = 1e6;  // of a piece

double positive(double size, uint64_t i) {
  if (!(size > 0 && size <= kLargest_m))
    fail(Status::kInvalidArgument, "a size of piece %llu is not between 0 and 1e6 m",
         static_cast<unsigned long long>(i));
  return size;
}

ConvexPiece hull_of(const jalon_gauge_piece& piece, const Transform& frame, const double* points,
                    uint64_t count, uint64_t i) {
  if (points == nullptr || piece.first > count || piece.count > count - piece.first)
    fail(Status::kInvalidArgument, "piece %llu wants hull points that are not there",
         static_cast<unsigned long long>(i));
  std::vector<Vec3> corners;
  for (uint64_t k = piece.first; k < piece.first + piece.count; ++k) {
    corners.push_back(frame.point({points[3 * k], points[3 * k + 1], points[3 * k + 2]}));
    if (!is_finite(corners.back()))
      fail(Status::kInvalidArgument, "hull point %llu is not finite",
           static_cast<unsigned long long>(k));
  }
  return ConvexPiece::hull(corners);
}

ConvexPiece piece_of(const jalon_gauge_piece& piece, const double* points, uint64_t count,
                     uint64_t i) {
  Transform frame = from_c(piece.frame);
  require_rigid(frame, ("the frame of piece " + std::to_string(i)).c_str());
  frame = orthonormal(frame);
  switch (piece.kind) {
    case JALON_GAUGE_BOX:
      return ConvexPiece::box(
          frame, {positive(piece.size.x, i), positive(piece.size.y, i), positive(piece.size.z, i)});
    case JALON_GAUGE_SPHERE:
      return ConvexPiece::sphere(frame.translation(), positive(piece.size.x, i));
    case JALON_GAUGE_CYLINDER:
      return ConvexPiece::cylinder(frame, positive(piece.size.x, i), positive(piece.size.z, i));
    case JALON_GAUGE_HULL:
      return hull_of(piece, frame, points, count, i);
    default:
      fail(Status::kInvalidArgument, "%d is no kind of piece: 1 box, 2 sphere, 3 cylinder, 4 hull",
           piece.kind);
  }
}

std::vector<ConvexPiece> gauge_of(const jalon_gauge_piece* pieces, uint64_t count,
                                  const double* points, uint64_t point_count) {
  if (count == 0 || count > kMaxPieces)
    fail(Status::kInvalidArgument, "%llu pieces; a gauge has 1 to 1000",
         static_cast<unsigned long long>(count));
  require(pieces, "pieces");
  if (point_count > 0) require_array(points, JALON_FLOAT64, point_count, 3, 0, "hull_points");
  std::vector<ConvexPiece> gauge;
  for (uint64_t i = 0; i < count; ++i) gauge.push_back(piece_of(pieces[i], points, point_count, i));
  return gauge;
}

std::vector<Transform> pose_list(const jalon_transform* poses, uint64_t count) {
  if (count == 0 || count > kMaxPoses)
    fail(Status::kInvalidArgument, "%llu poses; a trajectory has 1 to 10 000 000",
         static_cast<unsigned long long>(count));
  require(poses, "poses");
  std::vector<Transform> out;
  for (uint64_t i = 0; i < count; ++i) out.push_back(from_c(poses[i]));
  return out;
}

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
