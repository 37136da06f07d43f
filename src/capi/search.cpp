// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/search.h"

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "capi/support/guard.h"
#include "spatial/neighbours/radius_batch.h"
#include "spatial/octree/morton.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

constexpr uint32_t kMostNeighbours = 256;  // of the batch form

// The caller's queries as doubles; refuses those that are not finite.
std::vector<Vec3> read_queries(const void* queries, int32_t type, uint64_t count,
                               uint64_t stride_bytes) {
  const size_t stride = require_array(queries, type, count, 3, stride_bytes, "queries");
  Column column({"queries", ElementType::kFloat64, 3, "", ""}, count);
  store_converted(column, 0, queries, require_type(type), count, stride);
  const auto values = column.values<double>();
  std::vector<Vec3> out(count);
  for (size_t i = 0; i < count; ++i) {
    out[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    if (!is_finite(out[i]))
      fail(Status::kInvalidArgument, "query %zu has a coordinate that is not finite", i);
  }
  return out;
}

template <class T>
std::shared_ptr<Column> new_column(const char* name, size_t count, uint32_t components = 1,
                                   const char* unit = "", const char* meaning = "") {
  return std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), components, unit, meaning},
                                  count);
}

void write_neighbours(std::span<const Neighbour> found, uint64_t* indices, double* squared) {
  for (size_t j = 0; j < found.size(); ++j) {
    indices[j] = found[j].index == kNoPoint ? JALON_NO_POINT : found[j].index;
    if (squared != nullptr) squared[j] = found[j].squared_distance;
  }
}

void require_level(int32_t level, int32_t lowest) {
  if (level < lowest || level > kMaxLevel)
    fail(Status::kInvalidArgument, "level %d is outside %d ... %d", level, lowest, kMaxLevel);
}

}  // namespace

jalon_status jalon_cloud_knn(const jalon_cloud* cloud, const void* queries, int32_t type,
                             uint64_t count, uint64_t stride_bytes, uint32_t k, int32_t level,
                             jalon_task* task, uint64_t* indices, double* squared_distances) {
  return guard([&] {
    require(cloud, "cloud");
    const auto points = read_queries(queries, type, count, stride_bytes);
    if (k == 0) fail(Status::kInvalidArgument, "k is 0");
    if (count != 0) require(indices, "indices");
    if (level != JALON_LEVEL_AUTOMATIC) require_level(level, 1);
    if (count > std::numeric_limits<size_t>::max() / sizeof(Neighbour) / k)
      fail(Status::kInvalidArgument,
           "k times the number of queries does not fit the address space");
    // Answers are collected first: a cancelled call leaves the caller's arrays alone.
    Buffer<Neighbour> found(count * k);
    with_task(task, [&](Task& t) {
      std::shared_ptr<const Octree> tree;
      {
        ProgressSpan span(t, 0, 0.3);
        tree = cloud->cloud->octree(t);
      }
      ProgressSpan span(t, 0.3, 1, "searching neighbours");
      if (level != JALON_LEVEL_AUTOMATIC) {
        knn_at_level(*tree, points, k, level, t, found);
        return;
      }
      constexpr size_t kGrain = 256;
      parallel_for(t, count, kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const std::span<Neighbour> out(found.data() + i * k, k);
          for (size_t j = tree->knn(points[i], k, out); j < k; ++j)
            out[j] = {std::numeric_limits<double>::infinity(), kNoPoint};
        }
      });
    });
    write_neighbours({found.data(), found.size()}, indices, squared_distances);
  });
}

jalon_status jalon_cloud_knn_all(const jalon_cloud* cloud, uint32_t k, jalon_task* task,
                                 uint32_t* indices, float* squared_distances) {
  return guard([&] {
    require(cloud, "cloud");
    const size_t n = cloud->cloud->size();
    if (k == 0 || k > kMostNeighbours)
      fail(Status::kInvalidArgument, "k is %u; 1 ... %u are possible", k, kMostNeighbours);
    if (n != 0) require(indices, "indices");
    with_task(task, [&](Task& t) {
      std::shared_ptr<const Octree> tree;
      {
        ProgressSpan span(t, 0, 0.3);
        tree = cloud->cloud->octree(t);
      }
      ProgressSpan span(t, 0.3, 1, "searching neighbours");
      const auto order = tree->order();
      tree->for_each_knn(k, t, [&](const Octree::Batch& batch) {
        for (size_t i = 0; i < batch.count; ++i) {
          const size_t to = order[batch.first + i] * size_t{k};
          for (size_t j = 0; j < k; ++j) {
            const uint32_t position = batch.neighbours[i * k + j];
            indices[to + j] = position == kNoPoint ? kNoPoint : order[position];
            if (squared_distances != nullptr) squared_distances[to + j] = batch.squared[i * k + j];
          }
        }
      });
    });
  });
}

jalon_status jalon_cloud_radius_search(const jalon_cloud* cloud, const void* queries, int32_t type,
                                       uint64_t count, uint64_t stride_bytes, double radius_m,
                                       jalon_task* task, jalon_fields** ranges,
                                       jalon_fields** neighbours) {
  return guard([&] {
    require(cloud, "cloud");
    require(ranges, "ranges");
    require(neighbours, "neighbours");
    const auto points = read_queries(queries, type, count, stride_bytes);
    if (!(radius_m >= 0) || !std::isfinite(radius_m))
      fail(Status::kInvalidArgument, "the radius must be finite and not negative");
    Owned<jalon_fields> made_ranges = own<jalon_fields>(nullptr),
                        made_neighbours = own<jalon_fields>(nullptr);
    with_task(task, [&](Task& t) {
      std::shared_ptr<const Octree> tree;
      {
        ProgressSpan span(t, 0, 0.3);
        tree = cloud->cloud->octree(t);
      }
      ProgressSpan span(t, 0.3, 1, "searching neighbours");
      RadiusNeighbours found = radius_neighbours(*tree, points, radius_m, t);
      made_ranges.reset(new_fields(std::move(found.ranges)));
      made_neighbours.reset(new_fields(std::move(found.neighbours)));
    });
    *ranges = made_ranges.release();
    *neighbours = made_neighbours.release();
  });
}

jalon_status jalon_cloud_octree_cube(const jalon_cloud* cloud, jalon_task* task, jalon_vec3* origin,
                                     double* edge_m) {
  return guard([&] {
    require(cloud, "cloud");
    const Cube cube = with_task(task, [&](Task& t) { return cloud->cloud->octree(t)->cube(); });
    if (origin != nullptr) *origin = to_c(cube.origin);
    if (edge_m != nullptr) *edge_m = cube.edge;
  });
}

jalon_status jalon_cloud_cells(const jalon_cloud* cloud, int32_t level, jalon_task* task,
                               jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    require_level(level, 0);
    *out = with_task(task, [&](Task& t) {
             FieldTable table;
             const auto tree = cloud->cloud->octree(t);
             const auto cells = tree->cells(level, t);
             const Vec3 origin = tree->cube().origin;
             const double edge = std::ldexp(tree->cube().edge, -level);
             auto code =
                 new_column<uint64_t>("code", cells.size(), 1, "", "Morton code, 3 bits a level");
             auto first =
                 new_column<uint64_t>("first", cells.size(), 1, "", "first point in code order");
             auto count = new_column<uint64_t>("count", cells.size(), 1, "", "points of the cell");
             auto centre = new_column<double>("centre", cells.size(), 3, "m", "centre of the cell");
             for (size_t c = 0; c < cells.size(); ++c) {
               code->values<uint64_t>()[c] = cells[c].code;
               first->values<uint64_t>()[c] = cells[c].first;
               count->values<uint64_t>()[c] = cells[c].count;
               const CellNumbers n = cell_numbers(cells[c].code);
               const auto at = centre->values<double>().subspan(3 * c, 3);
               at[0] = origin.x + (n.p + 0.5) * edge;
               at[1] = origin.y + (n.q + 0.5) * edge;
               at[2] = origin.z + (n.r + 0.5) * edge;
             }
             table.set(std::move(code));
             table.set(std::move(first));
             table.set(std::move(count));
             table.set(std::move(centre));
             return own(new_fields(std::move(table)));
           }).release();
  });
}

jalon_status jalon_cloud_order(const jalon_cloud* cloud, jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             FieldTable table;
             const auto tree = cloud->cloud->octree(t);
             auto order = new_column<uint64_t>("order", tree->size(), 1, "",
                                               "indices of the points in code order");
             const auto from = tree->order();
             const auto to = order->values<uint64_t>();
             for (size_t i = 0; i < from.size(); ++i) to[i] = from[i];
             table.set(std::move(order));
             return own(new_fields(std::move(table)));
           }).release();
  });
}

jalon_status jalon_cloud_cell_neighbours(const jalon_cloud* cloud, int32_t level, uint64_t code,
                                         uint32_t reach, jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    require_level(level, 0);
    *out =
        with_task(task, [&](Task& t) {
          FieldTable table;
          const auto codes = cloud->cloud->octree(t)->neighbour_cells(level, code, reach);
          table.set(make_column<uint64_t>(
              {"code", ElementType::kUint64, 1, "", "codes of the occupied cells around"}, codes));
          return own(new_fields(std::move(table)));
        }).release();
  });
}

jalon_status jalon_cloud_best_level(const jalon_cloud* cloud, const jalon_cloud* compared,
                                    uint32_t k, jalon_task* task, int32_t* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(compared, "compared");
    require(out, "out");
    if (k == 0) fail(Status::kInvalidArgument, "k is 0");
    *out = with_task(task, [&](Task& t) {
      const auto reference = cloud->cloud->octree(t), other = compared->cloud->octree(t);
      return best_level(*reference, *other, k, t);
    });
  });
}

jalon_status jalon_cloud_share_octree(jalon_cloud* const* clouds, uint64_t count,
                                      jalon_task* task) {
  return guard([&] {
    if (count != 0) require(clouds, "clouds");
    for (uint64_t i = 0; i < count; ++i) require(clouds[i], "a cloud");
    with_task(task, [&](Task& t) {
      Box3 box;
      for (uint64_t i = 0; i < count; ++i)
        if (clouds[i]->cloud->size() != 0) box += bounds(*clouds[i]->cloud, t);
      if (box.empty()) return;
      const Cube cube = enclosing_cube(box);
      for (uint64_t i = 0; i < count; ++i) {
        ProgressSpan span(t, static_cast<double>(i) / static_cast<double>(count),
                          static_cast<double>(i + 1) / static_cast<double>(count));
        const Cloud& cloud = *clouds[i]->cloud;
        cloud.index->get_on(cloud.xyz(), cube, t);
      }
    });
  });
}
