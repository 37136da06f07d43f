// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/copc_writer.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/endian.h"
#include "formats/las/node_order.h"
#include "formats/las/records.h"

namespace jalon::las {

namespace {

constexpr size_t kCopcGrain = size_t{1} << 16;  // points a chunk

struct Times {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  Times& operator+=(const Times& b) {
    min = std::min(min, b.min);
    max = std::max(max, b.max);
    return *this;
  }
};

/// Of the points' times; nullptr where the file has none.
const Column* times_in(const Plan& plan) {
  for (const StandardColumn& standard : plan.standard)
    if (standard.column->info().name == "gps_time") return standard.column.get();
  return nullptr;
}

Times span_of(const Column& column, Task& task) {
  return visit(column.info().type, [&](auto zero) {
    const auto values = column.values<decltype(zero)>();
    return parallel_reduce<Times>(task, values.size(), kCopcGrain, {},
                                  [&](size_t begin, size_t end) {
                                    Times times;
                                    for (size_t i = begin; i < end; ++i) {
                                      const auto value = static_cast<double>(values[i]);
                                      times.min = std::min(times.min, value);
                                      times.max = std::max(times.max, value);
                                    }
                                    return times;
                                  });
  });
}

}  // namespace

Buffer<double> coordinates_in_file(const Plan& plan, const Cloud& cloud, Task& task) {
  Buffer<double> out(3 * cloud.size());
  const std::span<const double> xyz = cloud.xyz();
  parallel_for(task, cloud.size(), kCopcGrain, [&](size_t begin, size_t end) {
    for (size_t i = 3 * begin; i < 3 * end; ++i) {
      const int axis = static_cast<int>(i % 3);
      out[i] = steps_of(plan, xyz[i], axis) * plan.scale[axis] + plan.offset[axis];
    }
  });
  return out;
}

CopcWriter::CopcWriter(const Plan& plan, const Cloud& cloud, Task& task) {
  tree_ = copc_tree(coordinates_in_file(plan, cloud, task), task);
  const Column* times = times_in(plan);
  if (times == nullptr) return;
  const Times span = span_of(*times, task);
  if (span.min <= span.max) {
    gps_min_ = span.min;
    gps_max_ = span.max;
  }
  order_by_time(tree_, *times, task);
}

LazOrder CopcWriter::order() const {
  LazOrder order{tree_.order, {}};
  for (const CopcTree::Node& node : tree_.nodes) order.starts.push_back(node.first);
  order.starts.push_back(tree_.order.size());
  return order;
}

size_t CopcWriter::entries() const { return std::max<size_t>(1, tree_.nodes.size()); }

Record CopcWriter::hierarchy_record(uint64_t first_chunk, std::span<const uint64_t> sizes) const {
  std::vector<std::byte> page(entries() * kCopcEntryBytes);  // zeros: an empty root
  uint64_t at = first_chunk;
  for (size_t i = 0; i < tree_.nodes.size(); ++i) {
    const CopcTree::Node& node = tree_.nodes[i];
    if (sizes[i] > std::numeric_limits<int32_t>::max() ||
        node.count > std::numeric_limits<int32_t>::max())
      fail(Status::kLimit, "a node of a COPC file has at most 2^31 - 1 points and bytes");
    put_entry(page.data() + i * kCopcEntryBytes,
              {node.key, at, static_cast<int32_t>(sizes[i]), static_cast<int32_t>(node.count)});
    at += sizes[i];
  }
  return make_extended_record(kCopcUser, kCopcHierarchyRecord, "COPC hierarchy", page.data(),
                              page.size());
}

Record CopcWriter::record_of_info(const Page& page) const {
  const std::vector<std::byte> bytes = info_bytes(
      {tree_.centre, tree_.halfsize, tree_.spacing, page.offset, page.bytes, gps_min_, gps_max_});
  return make_record(kCopcUser, kCopcInfoRecord, "COPC info", bytes.data(), bytes.size());
}

Record CopcWriter::info_record(uint64_t hierarchy_offset) const {
  return record_of_info({hierarchy_offset, entries() * kCopcEntryBytes});
}

}  // namespace jalon::las
