// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/las/copc_writer.h"
#include "formats/las/header_writer.h"
#include "formats/las/las.h"
#include "formats/las/laz_writer.h"
#include "formats/las/plan.h"
#include "formats/las/records.h"

namespace jalon {

namespace {

using namespace las;

constexpr size_t kWriterGrain = size_t{1} << 14;  // points a chunk
constexpr size_t kBatchBytes = size_t{8} << 20;   // encoded in parallel, then written in one go

Written write_points(const Plan& plan, const Cloud& cloud, AtomicFile& file, Task& task) {
  const size_t n = cloud.size();
  const size_t batch =
      std::max<size_t>(kWriterGrain, kBatchBytes / plan.record_bytes / kWriterGrain * kWriterGrain);
  const auto records =
      std::make_unique_for_overwrite<std::byte[]>(std::min(batch, n) * plan.record_bytes);
  Tally total;
  for (size_t first = 0; first < n; first += batch) {
    const size_t count = std::min(batch, n - first);
    const auto fraction = [&](size_t i) { return static_cast<double>(i) / static_cast<double>(n); };
    ProgressSpan span(task, fraction(first), fraction(first + count));
    total +=
        parallel_reduce<Tally>(task, count, kWriterGrain, Tally{}, [&](size_t begin, size_t end) {
          return put_points(plan, cloud, records.get() + begin * plan.record_bytes, first + begin,
                            end - begin);
        });
    file.write(records.get(), count * plan.record_bytes);
  }
  return {total, uint64_t{n} * plan.record_bytes};
}

enum class Packing { kNone, kChunks, kOctree };

Plan plan_of(const Cloud& cloud, const std::string& path, WriteSettings settings, Packing packing,
             Task& task) {
  if (packing == Packing::kOctree) {
    if (settings.las_version == LasVersion::k12)
      fail(Status::kInvalidArgument, "%s: COPC files are of LAS 1.4", path.c_str());
    settings.las_version = LasVersion::k14;
  }
  return make_plan(cloud, path, settings, task,
                   packing == Packing::kOctree ? Profile::kCopc : Profile::kPlain);
}

Written write_packed(Plan& plan, const LazWriter& laz, const CopcWriter* copc, const Cloud& cloud,
                     AtomicFile& file, Task& task) {
  const uint64_t point_offset = point_offset_of(plan);
  const LazWritten written =
      laz.write(cloud, copc != nullptr ? copc->order() : laz.order_of(cloud.size()), file,
                point_offset, task);
  if (copc != nullptr)
    plan.evlrs.push_back(copc->hierarchy_record(point_offset + kLazPlaceBytes, written.sizes));
  return {written.tally, written.bytes};
}

void write_file(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Packing packing, Task& task) {
  Plan plan;
  std::optional<LazWriter> laz;
  std::optional<CopcWriter> copc;
  {
    ProgressSpan span(task, 0, 0.3, "writing LAS");
    plan = plan_of(cloud, path, settings, packing, task);
    if (packing == Packing::kOctree) {
      copc.emplace(plan, cloud, task);
      plan.vlrs.insert(plan.vlrs.begin(), copc->info_record());
    }
    if (packing != Packing::kNone) {
      laz.emplace(plan, path, copc ? LazWriter::Chunks::kOwn : LazWriter::Chunks::kEqual);
      plan.vlrs.push_back(laz->record());
    }
  }
  ProgressSpan span(task, 0.3, 0.99, "writing LAS");
  AtomicFile file(path);
  const bool compressed = packing != Packing::kNone;
  file.write(header_bytes(plan, {}, cloud.size(), compressed).data(), header_size(plan));
  for (const Record& record : plan.vlrs) file.write(record.bytes.data(), record.bytes.size());
  const Written written = laz ? write_packed(plan, *laz, copc ? &*copc : nullptr, cloud, file, task)
                              : write_points(plan, cloud, file, task);
  uint64_t end = point_offset_of(plan) + written.bytes;
  for (const Record& record : plan.evlrs) {
    file.write(record.bytes.data(), record.bytes.size());
    end += record.bytes.size();
  }
  if (copc) {  // whose hierarchy is the last record, in one page
    const Record info = copc->info_record(end - plan.evlrs.back().size());
    file.rewrite(header_size(plan), info.bytes.data(), info.bytes.size());
  }
  const std::vector<std::byte> header = header_bytes(plan, written, cloud.size(), compressed);
  file.rewrite(0, header.data(), header.size());
  task.checkpoint(1);  // the last chance to cancel before the old file goes
  file.commit();
}

}  // namespace

void write_las(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  write_file(cloud, path, settings, Packing::kNone, task);
}

void write_laz(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  require_codecs(path, "LAZ");
  write_file(cloud, path, settings, Packing::kChunks, task);
}

void write_copc(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Task& task) {
  require_codecs(path, "COPC");
  write_file(cloud, path, settings, Packing::kOctree, task);
}

}  // namespace jalon
