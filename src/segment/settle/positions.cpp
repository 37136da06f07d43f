// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/positions.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerStretch = 1 << 17;

// What comes to a surface and what goes from it, in one ascending list.
struct Change {
  uint32_t position;
  bool comes;
};

std::vector<uint32_t> changed(const std::vector<uint32_t>& positions,
                              const std::vector<Change>& changes) {
  std::vector<uint32_t> out;
  out.reserve(positions.size() + changes.size());
  auto from = positions.begin();
  for (const Change& change : changes) {
    const auto to = std::lower_bound(from, positions.end(), change.position);
    out.insert(out.end(), from, to);
    from = change.comes ? to : to + 1;
    if (change.comes) out.push_back(change.position);
  }
  out.insert(out.end(), from, positions.end());
  return out;
}

}  // namespace

// Counted by stretches of points, then put in place.
void take_positions(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const size_t n = scene.size(), count = surfaces.size();
  const size_t stretches = (n + kPointsPerStretch - 1) / kPointsPerStretch;
  std::vector<uint32_t> next(stretches * (count + 1), 0);  // by stretch and owner
  parallel_for(task, n, kPointsPerStretch, [&](size_t begin, size_t end) {
    uint32_t* counts = next.data() + begin / kPointsPerStretch * (count + 1);
    for (size_t i = begin; i < end; ++i) ++counts[scene.owner[i]];
  });
  for (size_t k = 1; k <= count; ++k) {
    uint32_t sum = 0;
    for (size_t stretch = 0; stretch < stretches; ++stretch)
      sum += std::exchange(next[stretch * (count + 1) + k], sum);
    surfaces[k - 1].positions = std::vector<uint32_t>(sum);
  }
  parallel_for(task, n, kPointsPerStretch, [&](size_t begin, size_t end) {
    uint32_t* places = next.data() + begin / kPointsPerStretch * (count + 1);
    for (size_t i = begin; i < end; ++i)
      if (const uint32_t k = scene.owner[i]; k != 0)
        surfaces[k - 1].positions[places[k]++] = static_cast<uint32_t>(i);
  });
}

void move_positions(const std::vector<std::vector<MovedPoint>>& moves,
                    std::vector<Surface>& surfaces, Task& task) {
  std::vector<std::vector<Change>> changes(surfaces.size() + 1);  // by owner
  for (const auto& part : moves)
    for (const MovedPoint& point : part) {
      changes[point.before].push_back({point.position, false});
      changes[point.now].push_back({point.position, true});
    }
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    if (!changes[s + 1].empty())
      surfaces[s].positions = changed(surfaces[s].positions, changes[s + 1]);
  });
}

}  // namespace jalon
