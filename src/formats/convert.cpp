// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <optional>

#include "formats/chosen_format.h"
#include "formats/files/single_precision.h"
#include "formats/files/station_file.h"
#include "formats/formats.h"
#include "formats/units/file_unit.h"
#include "formats/wanted_points.h"

namespace jalon {

namespace {

// Enough for all threads to share: ten chunks of a LAZ file; some 80 MB of memory with fields and records.
constexpr size_t kPiecePoints = size_t{1} << 19;

// A file that is read while it is written must be in memory.
bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code none;
  const auto path_of = [](const std::string& utf8) {
    return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
  };
  return std::filesystem::equivalent(path_of(a), path_of(b), none);
}

/// One file becoming another, piece by piece.
class Stream {
 public:
  Stream(const ByteSource& source, const ReadSettings& reading, const Format& written,
         const std::string& to, const WriteSettings& writing, Task& task)
      : source_(source), reading_(reading), task_(task) {
    const Format& read = format_to_read(source, reading);
    knows_units_ = read.knows_units;
    pieces_ = read.read_pieces(source, reading, task);
    if (pieces_ != nullptr) sink_ = written.write_pieces(to, writing, pieces_->count());
  }

  /// Points written; none where only a cloud of all points can be.
  std::optional<uint64_t> run() {
    if (pieces_ == nullptr || !look_through()) return std::nullopt;
    Cloud piece;
    bool has_piece = next_kept(piece);
    if (has_piece) warn_of_single_precision(piece, source_.path(), task_);
    if (has_piece && sink_->asks_for_bounds(piece, task_)) {
      sink_->tell_bounds(bounds_from(piece));
      pieces_->rewind();
      passed_ = 0;
      has_piece = next_kept(piece);
    }
    if (!has_piece && !sink_->put(last_, task_)) return std::nullopt;
    uint64_t kept = 0;
    for (; has_piece; has_piece = next_kept(piece)) {
      if (!put(piece)) return std::nullopt;
      kept += piece.size();
    }
    sink_->finish(task_);
    return kept;
  }

 private:
  bool look_through() {
    begin_ = pieces_->look_share();
    ProgressSpan span(task_, 0, begin_);
    return pieces_->look_through(task_);
  }

  double share(uint64_t points) const {
    const uint64_t all = std::max<uint64_t>(pieces_->count(), 1);
    const double done = static_cast<double>(std::min(points, all)) / static_cast<double>(all);
    return begin_ + (1 - begin_) * done;
  }

  // The next one with points.
  bool next_kept(Cloud& piece) {
    while (read_next(piece))
      if (piece.size() != 0) return true;
    return false;
  }

  bool read_next(Cloud& piece) {
    ProgressSpan span(task_, share(passed_),
                      share(passed_) / 2 + share(passed_ + kPiecePoints) / 2);
    piece = {};  // gone before the next one comes
    Cloud next;
    if (!pieces_->next(kPiecePoints, next, task_)) return false;
    const uint64_t first = passed_;
    passed_ += next.size();
    if (!knows_units_) next = in_metres(std::move(next), reading_.unit, task_);
    piece =
        wanted_points(std::move(next), first, pieces_->count(), source_.path(), reading_, task_);
    if (piece.size() == 0) last_ = piece;
    return true;
  }

  // Of this piece and those behind it; what is read for it is half of the work.
  Box3 bounds_from(Cloud& piece) {
    const double begin = begin_;
    Box3 box;
    do {
      box += bounds(piece, task_);
    } while (next_kept(piece));
    begin_ = begin / 2 + 0.5;
    return box;
  }

  bool put(const Cloud& piece) {
    ProgressSpan span(task_, share(passed_) - (share(piece.size()) - begin_) / 2, share(passed_),
                      "converting");
    return sink_->put(piece, task_);
  }

  const ByteSource& source_;
  const ReadSettings& reading_;
  Task& task_;
  bool knows_units_ = true;
  std::unique_ptr<CloudPieces> pieces_;
  std::unique_ptr<CloudSink> sink_;
  double begin_ = 0;     ///< of the work that is left, where the next pass begins
  uint64_t passed_ = 0;  ///< points read in this pass
  Cloud last_;           ///< without points, with all else
};

bool can_stream(const std::string& from, const std::string& to, const Format& read,
                const Format* written) {
  return written != nullptr && read.read_pieces != nullptr && written->write_pieces != nullptr &&
         !has_station_file(from) && !are_same_file(from, to);
}

std::optional<uint64_t> streamed(const std::string& from, const std::string& to,
                                 const ReadSettings& reading, const WriteSettings& writing,
                                 Task& task) {
  const ByteSource source(from);
  const Format* written = format_to_write(to, writing);
  if (!can_stream(from, to, format_to_read(source, reading), written)) return std::nullopt;
  reading.box_m();  // refused before anything is read
  if (reading.spacing_m > 0 && !is_copc(source)) return std::nullopt;
  const bool counts_at_end = !reading.box.empty() || reading.drop_invalid;
  if (!reading.station.empty() || (reading.max_points > 0 && counts_at_end)) return std::nullopt;
  const auto count = Stream(source, reading, *written, to, writing, task).run();
  if (count) write_station_file({}, to, true);
  return count;
}

}  // namespace

uint64_t convert_cloud(const std::string& from, const std::string& to,
                       const ConvertSettings& settings, Task& task) {
  if (const auto count = streamed(from, to, settings.reading, settings.writing, task))
    return *count;
  Cloud cloud;
  {
    ProgressSpan span(task, 0, 0.5, "reading");
    cloud = read_cloud(from, settings.reading, task);
  }
  ProgressSpan span(task, 0.5, 1, "writing");
  write_cloud(cloud, to, settings.writing, task);
  return cloud.size();
}

}  // namespace jalon
