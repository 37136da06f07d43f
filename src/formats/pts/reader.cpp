// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "formats/files/fast_number.h"
#include "formats/files/finish_cloud.h"
#include "formats/pts/pts.h"
#include "formats/text/layout.h"
#include "formats/text/line_reader.h"
#include "formats/text/text.h"

namespace jalon {

namespace {

constexpr size_t kPtsTicks = 4096;  // lines between two looks at the task

/// The lines behind one count, or before the first.
struct Block {
  double promised = -1;  ///< -1: no count stands before it
  uint64_t points = 0;
};

std::vector<Block> blocks_of(const ByteSource& source, const TextLayout& layout, Task& task) {
  std::vector<Block> blocks(1);
  LineReader lines(source);
  for (std::string_view line; lines.next(line);) {
    if (lines.number() % kPtsTicks == 0) task.checkpoint(lines.fraction());
    if (is_comment(line)) continue;
    if (is_count_line(line)) {
      ParsedNumber number;
      const size_t first = line.find_first_not_of(" \t");
      parse_number_at(line.data() + first, line.data() + line.size(), number);
      blocks.push_back({number.value, 0});
    } else if (lines.number() >= layout.data_line) {
      ++blocks.back().points;
    }
  }
  return blocks;
}

void warn_of_lies(const std::vector<Block>& blocks, const ByteSource& source, Task& task) {
  constexpr size_t kTold = 8;  // a file of lies is told once for all
  size_t lies = 0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].promised < 0 || blocks[b].promised == static_cast<double>(blocks[b].points))
      continue;
    if (++lies > kTold) continue;
    task.log(Task::kWarning, "%s: block %zu holds %llu points, not as many as its count says",
             source.path().c_str(), b, static_cast<unsigned long long>(blocks[b].points));
  }
  if (lies > kTold)
    task.log(Task::kWarning, "%s: %zu counts in all are wrong", source.path().c_str(), lies);
}

void add_stations(Cloud& cloud, const std::vector<Block>& blocks) {
  size_t filled = 0;
  for (const Block& block : blocks) filled += block.points != 0 ? 1 : 0;
  if (filled < 2) return;
  uint64_t first = 0;
  for (const Block& block : blocks) {
    if (block.points == 0) continue;
    Station station;
    station.name = "scan " + std::to_string(cloud.stations.size() + 1);
    station.first = first;
    station.count = block.points;
    first += block.points;
    cloud.stations.push_back(station);
  }
}

}  // namespace

Cloud read_pts(const ByteSource& source, const ReadSettings& settings, Task& task) {
  Cloud cloud;
  {
    ProgressSpan span(task, 0, 0.85);
    cloud = text_points(source, settings.columns, task);
  }
  const TextLayout layout = detect_text_layout(source, settings.columns);
  if (layout.count_lines) {
    ProgressSpan span(task, 0.85, 0.95, "counting blocks");
    const std::vector<Block> blocks = blocks_of(source, layout, task);
    warn_of_lies(blocks, source, task);
    add_stations(cloud, blocks);
  }
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

}  // namespace jalon
