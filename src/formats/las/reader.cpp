// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/files/cloud_pieces.h"
#include "formats/files/endian.h"
#include "formats/files/finish_cloud.h"
#include "formats/las/copc.h"
#include "formats/las/fields.h"
#include "formats/las/kept_records.h"
#include "formats/las/las.h"
#include "formats/las/laz.h"
#include "formats/las/layout.h"
#include "formats/las/point_sink.h"
#include "formats/las/stations.h"
#include "formats/units/file_unit.h"
#include "formats/wanted_points.h"

namespace jalon {

namespace {

using namespace las;

constexpr size_t kReaderGrain = size_t{1} << 16;  // points a chunk: some milliseconds
constexpr size_t kBlockBytes =
    size_t{96} << 10;  // read at once: stays in the cache, and below the allocator's mmap limit

// The unit that the user gave, or that the CRS says.
LengthUnits units_to_use(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                         const ByteSource& source, FileUnit unit, Task& task) {
  LengthUnits units;
  units.known = true;
  units.horizontal = units.vertical = metres_of(unit);
  if (unit == FileUnit::kAuto) units = units_of(vlrs, evlrs, source.path());
  if (units.degrees)
    task.log(Task::kWarning,
             "%s: the CRS is geographic: x and y are degrees, or the CRS is wrong; project the "
             "file before measuring in it",
             source.path().c_str());
  if (!units.metres())
    task.log(Task::kInfo, "%s: coordinates are in feet or another unit; converted to metres",
             source.path().c_str());
  return units;
}

/// Points of a file one behind the other: of LAS any, of LAZ those of whole chunks.
struct PointRun {
  size_t first = 0, count = 0;
  size_t first_chunk = 0, chunks = 0;
};

void decode_points(const ByteSource& source, PointSink& sink, const PointRun& run, Task& task) {
  const Header& header = sink.header();
  const size_t stride = header.record_bytes;
  const size_t block = std::max<size_t>(1, kBlockBytes / stride);
  parallel_for(task, run.count, kReaderGrain, [&](size_t begin, size_t end) {
    const size_t room = std::min(block, end - begin) * stride;
    const auto records = std::make_unique_for_overwrite<std::byte[]>(room);
    for (size_t first = begin; first < end; first += block) {
      const size_t n = std::min(block, end - first);
      source.read(header.point_offset + uint64_t{run.first + first} * stride, records.get(),
                  n * stride);
      sink.put(records.get(), n, first);
    }
  });
}

void decompress_points(const LazPoints& laz, PointSink& sink, const PointRun& run, Task& task) {
  parallel_chunks(task, run.chunks, [&](size_t k) {
    const size_t c = run.first_chunk + k;
    if (laz.points(c) != 0)
      sink.put(laz.decode(c).get(), laz.points(c), laz.first_point(c) - run.first);
  });
}

std::shared_ptr<const std::vector<Attachment>> attachments_of(const Header& header,
                                                              std::vector<Record> vlrs,
                                                              std::vector<Record> evlrs) {
  auto out = std::make_shared<std::vector<Attachment>>();
  out->push_back({"las:header", header.raw});
  for (Record& record : vlrs)
    if (!is_copc_record(record)) out->push_back({"las:vlr", std::move(record.bytes)});
  for (Record& record : evlrs) out->push_back({"las:evlr", std::move(record.bytes)});
  return out;
}

// The octree's cells are in the file's unit, the options in metres.
CopcPart part_of(const CopcInfo& info, const Vec3& unit, const ReadSettings& settings) {
  CopcPart part;
  const Box3 box = settings.box_m();
  for (int k = 0; k < 3; ++k) {
    part.box.min[k] = box.min[k] / unit[k];
    part.box.max[k] = box.max[k] / unit[k];
  }
  if (settings.spacing_m > 0) part.most_level = level_of(info, settings.spacing_m / unit.x);
  return part;
}

LazPoints packed_points(const ByteSource& source, const Header& header,
                        const std::vector<Record>& vlrs, const Vec3& unit,
                        const ReadSettings& settings, Task& task) {
  require_codecs(source.path(), "LAZ");
  const std::optional<CopcInfo> info = copc_info(source, vlrs);
  if (!info || settings.reads_all()) return {source, header, vlrs};
  return {source, header, vlrs,
          copc_chunks(source, header, *info, part_of(*info, unit, settings), task)};
}

/// What stands before and behind the points of a file.
struct LasFrame {
  LasFrame(const ByteSource& source, Task& task)
      : header(read_header(source)),
        vlrs(read_vlrs(source, header, task)),
        evlrs(read_evlrs(source, header, task)) {}

  bool tells_stations() const {
    return std::ranges::any_of(vlrs, is_station_record) ||
           std::ranges::any_of(evlrs, is_station_record);
  }

  Header header;
  std::vector<Record> vlrs, evlrs;
};

/// A file, opened: its frame, and any run of its points as a cloud.
struct LasReading : LasFrame {
  LasReading(const ByteSource& file, LasFrame frame, const ReadSettings& settings, Task& task)
      : LasFrame(std::move(frame)), source(file), crs(crs_text(vlrs, evlrs)) {
    const LengthUnits units = units_to_use(vlrs, evlrs, source, settings.unit, task);
    unit = {units.horizontal, units.horizontal, units.vertical};
    if (header.compressed) {
      laz.emplace(packed_points(source, header, vlrs, unit, settings, task));
      laz->require_points(task);
    }
    standard = dimensions(header.format);
    extra = extra_dimensions(vlrs, evlrs, header.record_bytes - point_format(header.format)->bytes,
                             task);
    for (ExtraDimension& dimension : extra)
      dimension.field.name = field_of_exact(header.format, dimension.field.name);
    leave_out(settings);
  }

  // Fields that nobody wants are not decoded, but what tells the stations; all are where one is missing, for the
  // message.
  void leave_out(const ReadSettings& settings) {
    std::vector<std::string> names;
    for (const Dimension& dimension : standard) names.push_back(dimension.field.name);
    for (const ExtraDimension& dimension : extra) names.push_back(dimension.field.name);
    if (!wants_only(settings, names)) return;
    const std::string stations = station_field(vlrs, evlrs);
    const auto is_unwanted = [&](const auto& dimension) {
      return dimension.field.name != stations && !wants_field(settings, dimension.field.name);
    };
    std::erase_if(standard, is_unwanted);
    std::erase_if(extra, is_unwanted);
  }

  size_t count() const { return laz ? laz->count() : header.count; }
  PointRun whole() const { return {0, count(), 0, laz ? laz->chunks() : 0}; }

  /// What follows: about so many points, at least one chunk; none at the end.
  PointRun behind(const PointRun& before, size_t most) const {
    PointRun run{before.first + before.count, 0, before.first_chunk + before.chunks, 0};
    if (!laz) run.count = std::min(most, count() - run.first);
    else
      for (size_t c = run.first_chunk; c < laz->chunks() && run.count < most; ++c, ++run.chunks)
        run.count += laz->points(c);
    return run;
  }

  Cloud points(const PointRun& run, Task& task) const {
    return filled_cloud(run.count, [&](PointSink& sink) {
      ProgressSpan span(task, 0, 0.95, "reading LAS");
      if (laz) decompress_points(*laz, sink, run, task);
      else decode_points(source, sink, run, task);
    });
  }

  /// Of a compressed file those in the box, and those that are nowhere, which are told of later.
  Cloud points_within(const Box3& box_m, Task& task) const {
    const auto is_kept = [&](const std::byte* record) {
      const Vec3 p = place_of(header, unit, record);
      return box_m.contains(p) || !std::isfinite(p.x + p.y + p.z);
    };
    std::optional<KeptRecords> kept;
    {
      ProgressSpan span(task, 0, 0.8, "reading LAS");
      kept.emplace(*laz, header.record_bytes, step_box(header, unit, box_m), is_kept, task);
    }
    ProgressSpan span(task, 0.8, 0.95, "reading LAS");
    return filled_cloud(kept->count(), [&](PointSink& sink) {
      kept->give(
          [&](const std::byte* records, size_t n, size_t first) { sink.put(records, n, first); },
          task);
    });
  }

  const ByteSource& source;
  const std::string crs;
  Vec3 unit;  ///< metres
  std::optional<LazPoints> laz;

 private:
  /// With its fields and CRS.
  template <class Fill>
  Cloud filled_cloud(size_t count, Fill&& fill) const {
    PointSink sink(header, unit, standard, extra, count);
    fill(sink);
    Cloud cloud = sink.cloud();
    cloud.crs = crs;
    return cloud;
  }

  std::vector<Dimension> standard;
  std::vector<ExtraDimension> extra;
};

/// A file of no stations piece by piece, in its order.
class LasPieces : public CloudPieces {
 public:
  LasPieces(std::unique_ptr<LasReading> file, const ByteSource& source, bool drop_invalid)
      : file_(std::move(file)), source_(source), drop_invalid_(drop_invalid) {
    attachments_ = attachments_of(file_->header, std::move(file_->vlrs), std::move(file_->evlrs));
  }

  uint64_t count() const override { return file_->count(); }

  void rewind() override {
    run_ = {};
    is_first_ = true;
  }

  bool next(size_t most, Cloud& piece, Task& task) override {
    piece = {};
    run_ = file_->behind(run_, most);
    if (run_.count == 0 && !is_first_) return false;
    is_first_ = false;
    piece = file_->points(run_, task);
    piece.attachments = attachments_;
    piece = finish_cloud(std::move(piece), source_, drop_invalid_, task);
    return true;
  }

 private:
  std::unique_ptr<LasReading> file_;
  const ByteSource& source_;
  bool drop_invalid_;
  std::shared_ptr<const std::vector<Attachment>> attachments_;
  PointRun run_;
  bool is_first_ = true;
};

}  // namespace

bool is_las(const ByteSource& source) {
  char start[4];
  return std::string_view(start, source.read_some(0, start, sizeof start)) == "LASF";
}

bool is_laz(const ByteSource& source) {
  constexpr uint64_t kFormat = 104;
  std::byte format{};
  return is_las(source) && source.read_some(kFormat, &format, 1) == 1 &&
         (format & std::byte{0xC0}) != std::byte{0};
}

bool is_copc(const ByteSource& source) {
  std::byte record[kVlrHeader];
  constexpr uint64_t kFirstRecord = 375;  // behind the header of LAS 1.4
  return is_laz(source) && source.read_some(kFirstRecord, record, sizeof record) == sizeof record &&
         record_of({record, record + sizeof record}, kVlrHeader).is(kCopcUser, kCopcInfoRecord);
}

Cloud read_las(const ByteSource& source, const ReadSettings& settings, Task& task) {
  LasReading file(source, LasFrame(source, task), settings, task);
  // Stations tell of all points of their own.
  const bool keeps_box = is_copc(source) && !settings.box.empty() && !file.tells_stations();
  Cloud cloud =
      keeps_box ? file.points_within(settings.box_m(), task) : file.points(file.whole(), task);
  cloud = with_stations(std::move(cloud), file.vlrs, file.evlrs, file.unit, source.path(), task);
  cloud.attachments = attachments_of(file.header, std::move(file.vlrs), std::move(file.evlrs));
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

std::unique_ptr<CloudPieces> las_pieces(const ByteSource& source, const ReadSettings& settings,
                                        Task& task) {
  LasFrame frame(source, task);
  if (frame.tells_stations()) return nullptr;
  auto file = std::make_unique<LasReading>(source, std::move(frame), settings, task);
  return std::make_unique<LasPieces>(std::move(file), source, settings.drop_invalid);
}

}  // namespace jalon
