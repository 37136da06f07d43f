// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "formats/las/copc_tree.h"
#include "formats/las/laz_writer.h"
#include "formats/las/plan.h"

namespace jalon::las {

/// The coordinates that a file of these steps will give back, in its unit: nodes are told by them.
Buffer<double> coordinates_in_file(const Plan& plan, const Cloud& cloud, Task& task);

/// What makes a LAZ file one of COPC: its points node by node, and the records that tell of them.
class CopcWriter {
 public:
  CopcWriter(const Plan& plan, const Cloud& cloud, Task& task);

  LazOrder order() const;
  /// The first record of the file, of one length whatever it tells: of the hierarchy nothing yet.
  Record info_record() const { return record_of_info({}); }
  /// The last one of the extended records, for chunks of these sizes from this place on.
  Record hierarchy_record(uint64_t first_chunk, std::span<const uint64_t> sizes) const;
  /// The first record again, of a file whose hierarchy begins there.
  Record info_record(uint64_t hierarchy_offset) const;

 private:
  struct Page {
    uint64_t offset = 0, bytes = 0;
  };
  Record record_of_info(const Page& page) const;
  size_t entries() const;
  CopcTree tree_;
  double gps_min_ = 0, gps_max_ = 0;
};

}  // namespace jalon::las
