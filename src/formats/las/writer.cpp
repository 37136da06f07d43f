// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/las/las.h"
#include "formats/las/plan.h"

namespace jalon {

namespace {

using namespace las;

constexpr size_t kWriterGrain = size_t{1} << 14;  // points a chunk
constexpr size_t kBatchBytes = size_t{8} << 20;   // encoded in parallel, then written in one go
constexpr uint16_t kWktBit = 16, kTimeTypeBit = 1, kSyntheticReturnsBit = 8;

/// What the header says about the points; sums and extremes, so the order of chunks does not
/// matter.
struct Tally {
  std::array<int64_t, 3> min{std::numeric_limits<int64_t>::max(),
                             std::numeric_limits<int64_t>::max(),
                             std::numeric_limits<int64_t>::max()};
  std::array<int64_t, 3> max{std::numeric_limits<int64_t>::min(),
                             std::numeric_limits<int64_t>::min(),
                             std::numeric_limits<int64_t>::min()};
  std::array<uint64_t, 16> by_return{};

  Tally& operator+=(const Tally& b) {
    for (size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], b.min[k]);
      max[k] = std::max(max[k], b.max[k]);
    }
    for (size_t k = 0; k < by_return.size(); ++k) by_return[k] += b.by_return[k];
    return *this;
  }
};

void put_standard(const StandardColumn& standard, std::byte* records, size_t stride, size_t first,
                  size_t n) {
  const Place& place = standard.place;
  std::byte* to = records + place.offset;
  visit(standard.column->info().type, [&](auto zero) {
    using T = decltype(zero);
    const T* from = static_cast<const T*>(standard.column->raw()) + first;
    if (place.bits != 0) {
      for (size_t i = 0; i < n; ++i)
        to[i * stride] |= static_cast<std::byte>(static_cast<unsigned>(from[i]) << place.shift);
      return;
    }
    visit(place.type, [&](auto stored_zero) {
      using Stored = decltype(stored_zero);
      for (size_t i = 0; i < n; ++i) {
        if (place.factor != 1)
          store<Stored>(
              to + i * stride,
              static_cast<Stored>(std::nearbyint(static_cast<double>(from[i]) / place.factor)));
        else store<Stored>(to + i * stride, static_cast<Stored>(from[i]));
      }
    });
  });
}

void put_extra(const ExtraColumn& extra, std::byte* records, size_t stride, size_t first,
               size_t n) {
  const size_t components = extra.column->info().components;
  visit(extra.raw_type, [&](auto raw_zero) {
    using Raw = decltype(raw_zero);
    for (size_t i = 0; i < n; ++i)
      for (size_t c = 0; c < extra.components; ++c) {
        const size_t at = (first + i) * components + extra.component + c;
        std::byte* to = records + i * stride + extra.offset + c * sizeof(Raw);
        if (extra.scaled) {
          const double value = static_cast<const double*>(extra.column->raw())[at];
          store<Raw>(to,
                     static_cast<Raw>(std::nearbyint((value - extra.shift[c]) / extra.scale[c])));
        } else {
          store<Raw>(to, static_cast<const Raw*>(extra.column->raw())[at]);
        }
      }
  });
}

Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records, size_t first, size_t n) {
  const size_t stride = plan.record_bytes;
  const Vec3 unit{plan.units.horizontal, plan.units.horizontal, plan.units.vertical};
  const double* xyz = cloud.xyz().data() + 3 * first;
  std::memset(records, 0, n * stride);
  Tally tally;
  for (size_t i = 0; i < n; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      // The plan made sure that it fits.
      const auto steps = static_cast<int32_t>(
          std::nearbyint((xyz[3 * i + k] / unit[axis] - plan.offset[axis]) / plan.scale[axis]));
      store<int32_t>(records + i * stride + 4 * k, steps);
      tally.min[k] = std::min<int64_t>(tally.min[k], steps);
      tally.max[k] = std::max<int64_t>(tally.max[k], steps);
    }
  for (const StandardColumn& standard : plan.standard)
    put_standard(standard, records, stride, first, n);
  for (const ExtraColumn& extra : plan.extra) put_extra(extra, records, stride, first, n);
  const unsigned mask = point_format(plan.format)->extended ? 15 : 7;
  for (size_t i = 0; i < n; ++i)
    ++tally.by_return[static_cast<unsigned>(records[i * stride + 14]) & mask];
  return tally;
}

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
  if (wkt && plan.version_minor == 4) encoding |= kWktBit;
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

std::vector<std::byte> header_bytes(const Plan& plan, const Tally& tally, uint64_t count) {
  std::vector<std::byte> out(plan.version_minor == 4 ? 375 : 227);
  put_identity(out.data(), plan);
  uint64_t point_offset = out.size();
  for (const Record& record : plan.vlrs) point_offset += record.bytes.size();
  if (point_offset > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "the records before the points take more than 4 GiB");
  out[24] = std::byte{1};
  out[25] = static_cast<std::byte>(plan.version_minor);
  store<uint16_t>(out.data() + 94, static_cast<uint16_t>(out.size()));
  store<uint32_t>(out.data() + 96, static_cast<uint32_t>(point_offset));
  store<uint32_t>(out.data() + 100, static_cast<uint32_t>(plan.vlrs.size()));
  out[104] = static_cast<std::byte>(plan.format);
  store<uint16_t>(out.data() + 105, static_cast<uint16_t>(plan.record_bytes));
  put_tally(out.data(), plan, tally, count);
  if (!plan.evlrs.empty()) {
    store<uint64_t>(out.data() + 235, point_offset + count * plan.record_bytes);
    store<uint32_t>(out.data() + 243, static_cast<uint32_t>(plan.evlrs.size()));
  }
  return out;
}

Tally write_points(const Plan& plan, const Cloud& cloud, AtomicFile& file, Task& task) {
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
  return total;
}

}  // namespace

void write_las(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  Plan plan;
  {
    ProgressSpan span(task, 0, 0.3, "writing LAS");
    plan = make_plan(cloud, path, settings, task);
  }
  ProgressSpan span(task, 0.3, 0.99, "writing LAS");
  AtomicFile file(path);
  file.write(header_bytes(plan, {}, cloud.size()).data(), plan.version_minor == 4 ? 375 : 227);
  for (const Record& record : plan.vlrs) file.write(record.bytes.data(), record.bytes.size());
  const Tally tally = write_points(plan, cloud, file, task);
  for (const Record& record : plan.evlrs) file.write(record.bytes.data(), record.bytes.size());
  const std::vector<std::byte> header = header_bytes(plan, tally, cloud.size());
  file.rewrite(0, header.data(), header.size());
  task.checkpoint(1);  // the last chance to cancel before the old file goes
  file.commit();
}

}  // namespace jalon
