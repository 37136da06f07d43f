// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>

#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/files/atomic_file.h"
#include "formats/las/header_writer.h"
#include "formats/las/las.h"
#include "formats/las/laz_writer.h"

namespace jalon {

namespace {

using namespace las;

constexpr size_t kPieceGrain = size_t{1} << 14;  // points that a thread encodes at once

ColumnPtr without_values(const ColumnPtr& column) {
  return std::make_shared<Column>(column->info(), 0);
}

bool are_same_records(const std::vector<Record>& a, const std::vector<Record>& b) {
  return std::ranges::equal(a, b, {}, &Record::bytes, &Record::bytes);
}

bool are_same_places(const StandardColumn& a, const StandardColumn& b) {
  const auto all = [](const StandardColumn& c) {
    return std::tuple(c.column->info().name, c.column->info().type, c.place.type, c.place.offset,
                      c.place.shift, c.place.bits, c.place.factor);
  };
  return all(a) == all(b);
}

bool are_same_extras(const ExtraColumn& a, const ExtraColumn& b) {
  const auto all = [](const ExtraColumn& c) {
    return std::tuple(c.column->info().name, c.offset, c.component, c.components, c.scaled,
                      c.raw_type, c.scale, c.shift, c.descriptor);
  };
  return all(a) == all(b);
}

// The plans of two pieces are that of the whole where nothing in them tells the pieces apart.
bool are_same_plans(const Plan& a, const Plan& b) {
  return a.version_minor == b.version_minor && a.format == b.format &&
         a.record_bytes == b.record_bytes && norm(a.scale - b.scale) == 0 &&
         norm(a.offset - b.offset) == 0 && are_same_records(a.vlrs, b.vlrs) &&
         are_same_records(a.evlrs, b.evlrs) &&
         std::ranges::equal(a.standard, b.standard, are_same_places) &&
         std::ranges::equal(a.extra, b.extra, are_same_extras);
}

/// A LAS file of one point format, steps and records, settled by the first piece.
class LasSink : public CloudSink {
 public:
  LasSink(std::string path, WriteSettings settings, uint64_t points, bool is_packed)
      : path_(std::move(path)), settings_(std::move(settings)), is_packed_(is_packed) {
    if (settings_.las_version == LasVersion::kAuto && points > std::numeric_limits<uint32_t>::max())
      settings_.las_version = LasVersion::k14;
  }

  bool asks_for_bounds(const Cloud& first, Task& task) const override {
    return make_plan(first, path_, settings_, task).has_steps_of_bounds;
  }

  void tell_bounds(const Box3& bounds) override { bounds_ = bounds; }

  bool put(const Cloud& piece, Task& task) override {
    if (!piece.stations.empty() || leaves_records_out(piece)) return false;
    Plan plan = make_plan(piece, path_, settings_, task, Profile::kPlain, bounds_);
    if (!file_) start(plan);
    else if (!are_same_plans(settled_, plan)) return false;
    const size_t n = piece.size();
    records_.resize(n * plan.record_bytes);
    tally_ += parallel_reduce<Tally>(task, n, kPieceGrain, Tally{}, [&](size_t begin, size_t end) {
      return put_points(plan, piece, records_.data() + begin * plan.record_bytes, begin,
                        end - begin);
    });
    if (stream_) stream_->put(records_, task);
    else file_->write(records_.data(), records_.size());
    count_ += n;
    return true;
  }

  void finish(Task& task) override {
    const uint64_t bytes = stream_ ? stream_->finish(task).bytes : count_ * plan_.record_bytes;
    for (const Record& record : plan_.evlrs) file_->write(record.bytes.data(), record.bytes.size());
    const auto header = header_bytes(plan_, {tally_, bytes}, count_, is_packed_);
    file_->rewrite(0, header.data(), header.size());
    task.checkpoint(1);  // the last chance to cancel before the old file goes
    file_->commit();
  }

 private:
  // Which the plan of each piece would say again.
  bool leaves_records_out(const Cloud& piece) const {
    return settings_.las_version == LasVersion::k12 && piece.attachments != nullptr &&
           std::ranges::any_of(*piece.attachments,
                               [](const Attachment& a) { return a.key == "las:evlr"; });
  }

  // Header and records stand before the points, the first as long as it will be.
  void start(const Plan& plan) {
    settled_ = plan;
    for (StandardColumn& column : settled_.standard) column.column = without_values(column.column);
    for (ExtraColumn& column : settled_.extra) column.column = without_values(column.column);
    plan_ = settled_;
    if (is_packed_) {
      laz_.emplace(plan_, path_);
      plan_.vlrs.push_back(laz_->record());
    }
    file_.emplace(path_);
    const auto header = header_bytes(plan_, {}, 0, is_packed_);
    file_->write(header.data(), header.size());
    for (const Record& record : plan_.vlrs) file_->write(record.bytes.data(), record.bytes.size());
    if (laz_) stream_.emplace(*laz_, *file_, point_offset_of(plan_));
  }

  const std::string path_;
  WriteSettings settings_;
  const bool is_packed_;
  std::optional<Box3> bounds_;  ///< of all pieces
  Plan settled_;                ///< by the first piece, with columns without values
  Plan plan_;                   ///< the same with the record of the compressor
  std::optional<AtomicFile> file_;
  std::optional<LazWriter> laz_;
  std::optional<LazStream> stream_;
  std::vector<std::byte> records_;
  Tally tally_;
  uint64_t count_ = 0;
};

}  // namespace

std::unique_ptr<CloudSink> las_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t points) {
  return std::make_unique<LasSink>(path, settings, points, false);
}

std::unique_ptr<CloudSink> laz_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t points) {
  require_codecs(path, "LAZ");
  return std::make_unique<LasSink>(path, settings, points, true);
}

}  // namespace jalon
