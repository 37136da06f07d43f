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
#include "formats/las/las.h"
#include "formats/las/laz_writer.h"
#include "formats/las/plan.h"
#include "formats/las/records.h"

namespace jalon {

namespace {

using namespace las;

constexpr size_t kWriterGrain = size_t{1} << 14;  // points a chunk
constexpr size_t kBatchBytes = size_t{8} << 20;   // encoded in parallel, then written in one go
constexpr unsigned kCompressed = 0x80;            // of the byte of the point format (LASzip)
constexpr uint16_t kWktBit = 16, kTimeTypeBit = 1, kSyntheticReturnsBit = 8;

void put_text(std::byte* to, const char* text) { std::memcpy(to, text, std::strlen(text)); }

void put_identity(std::byte* out, const Plan& plan) {
  if (!plan.old_header.empty()) {
    std::memcpy(out, plan.old_header.data(), 58);  // source id, encoding, project id, system
    std::memcpy(out + 90, plan.old_header.data() + 90, 4);                // date
    if (plan.old_header[25] == std::byte{0}) std::memset(out + 4, 0, 4);  // reserved in 1.0
  } else {
    put_text(out + 26, "OTHER");
  }
  put_text(out, "LASF");
  put_text(out + 58, "Jalon");
  bool wkt = false;
  for (const auto* list : {&plan.vlrs, &plan.evlrs})
    for (const Record& record : *list) wkt = wkt || record.is("LASF_Projection", 2112);
  uint16_t encoding = load<uint16_t>(out + 6) & (kTimeTypeBit | kSyntheticReturnsBit);
  // COPC has no other texts of a CRS, and readers ask for the bit where it has none too.
  const bool is_copc = !plan.vlrs.empty() && is_copc_record(plan.vlrs[0]);
  if ((wkt && plan.version_minor == 4) || is_copc) encoding |= kWktBit;
  store<uint16_t>(out + 6, encoding);
}

void put_tally(std::byte* out, const Plan& plan, const Tally& tally, uint64_t count) {
  const bool extended = point_format(plan.format)->extended;
  if (!extended) {
    store<uint32_t>(out + 107, static_cast<uint32_t>(count));
    for (size_t r = 0; r < 5; ++r)
      store<uint32_t>(out + 111 + 4 * r, static_cast<uint32_t>(tally.by_return[r + 1]));
  }
  if (plan.version_minor == 4) {
    store<uint64_t>(out + 247, count);
    for (size_t r = 0; r < 15; ++r) store<uint64_t>(out + 255 + 8 * r, tally.by_return[r + 1]);
  }
  for (size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const auto coordinate = [&](int64_t steps) {
      return count == 0 ? 0 : static_cast<double>(steps) * plan.scale[axis] + plan.offset[axis];
    };
    store<double>(out + 131 + 8 * k, plan.scale[axis]);
    store<double>(out + 155 + 8 * k, plan.offset[axis]);
    const double a = coordinate(tally.min[k]),
                 b = coordinate(tally.max[k]);  // a negative scale turns them round
    store<double>(out + 179 + 16 * k, std::max(a, b));
    store<double>(out + 187 + 16 * k, std::min(a, b));
  }
}

size_t header_size(const Plan& plan) { return plan.version_minor == 4 ? 375 : 227; }

uint64_t point_offset_of(const Plan& plan) {
  uint64_t offset = header_size(plan);
  for (const Record& record : plan.vlrs) offset += record.bytes.size();
  return offset;
}

/// What was written between the header and the extended records.
struct Written {
  Tally tally;
  uint64_t bytes = 0;  ///< of the points
};

std::vector<std::byte> header_bytes(const Plan& plan, const Written& written, uint64_t count,
                                    bool compressed) {
  std::vector<std::byte> out(header_size(plan));
  put_identity(out.data(), plan);
  const uint64_t point_offset = point_offset_of(plan);
  if (point_offset > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "the records before the points take more than 4 GiB");
  out[24] = std::byte{1};
  out[25] = static_cast<std::byte>(plan.version_minor);
  store<uint16_t>(out.data() + 94, static_cast<uint16_t>(out.size()));
  store<uint32_t>(out.data() + 96, static_cast<uint32_t>(point_offset));
  store<uint32_t>(out.data() + 100, static_cast<uint32_t>(plan.vlrs.size()));
  out[104] = static_cast<std::byte>(plan.format | (compressed ? kCompressed : 0));
  store<uint16_t>(out.data() + 105, static_cast<uint16_t>(plan.record_bytes));
  put_tally(out.data(), plan, written.tally, count);
  if (!plan.evlrs.empty()) {
    store<uint64_t>(out.data() + 235, point_offset + written.bytes);
    store<uint32_t>(out.data() + 243, static_cast<uint32_t>(plan.evlrs.size()));
  }
  return out;
}

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
  return make_plan(cloud, path, settings, task);
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
