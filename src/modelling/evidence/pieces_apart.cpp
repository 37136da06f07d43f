// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/pieces_apart.h"

#include <algorithm>
#include <cmath>

#include "modelling/evidence/coplanar.h"
#include "modelling/evidence/plane_roles.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

constexpr double kPiecesSameWay = 0.985;  // cosine of 10 degrees
constexpr size_t kPiecePoints = 400;      // looked at, of a piece

// Whether most of a piece's points lie in openings of walls that explain more than what it is a piece of.
bool is_filling_piece(const Cloud& cloud, std::span<const uint32_t> points,
                      const WallEvidence& whole, const std::vector<WallEvidence>& evidence) {
  std::vector<const WallEvidence*> walls;
  const double explained = explained_m2(whole);
  for (const WallEvidence& wall : evidence)
    if (&wall != &whole && wall.is_wall() && explained_m2(wall) > explained &&
        dot(wall.cells.frame.normal, whole.cells.frame.normal) >= kPiecesSameWay)
      walls.push_back(&wall);
  const size_t step = std::max<size_t>(1, points.size() / kPiecePoints);
  size_t looked = 0, inside = 0;
  for (size_t i = step / 2; i < points.size() && !walls.empty(); i += step, ++looked)
    inside += std::any_of(walls.begin(), walls.end(), [&](const WallEvidence* wall) {
      return is_filling_at(*wall, cloud.point(points[i]));
    });
  return looked > 0 && static_cast<double>(inside) >= kFillingShare * static_cast<double>(looked);
}

// The pieces become those of their largest.
void join_to_largest(const std::vector<Segment>& segments, std::span<const size_t> pieces,
                     std::vector<uint32_t>& whole) {
  const size_t largest = *std::max_element(pieces.begin(), pieces.end(), [&](size_t a, size_t b) {
    return segments[a].point_count() < segments[b].point_count();
  });
  for (const size_t piece : pieces) whole[piece] = segments[largest].label;
}

}  // namespace

std::vector<uint32_t> pieces_apart(const Segmentation& given, const std::vector<uint32_t>& whole,
                                   const std::vector<WallEvidence>& evidence, Task& task) {
  const LabelGroups groups(given.labels->values<uint32_t>(), given.segments.size(), task);
  std::vector<std::vector<size_t>> pieces(given.segments.size());
  for (size_t s = 0; s < whole.size(); ++s) pieces[whole[s] - 1].push_back(s);
  std::vector<uint32_t> out = whole;
  for (size_t w = 0; w < pieces.size(); ++w) {
    if (pieces[w].size() < 2 || evidence[w].empty()) continue;
    std::vector<size_t> fillings, others;
    for (const size_t s : pieces[w]) {
      task.checkpoint(0);
      const bool is_filling =
          is_filling_piece(*given.cloud, groups.of(given.segments[s].label), evidence[w], evidence);
      (is_filling ? fillings : others).push_back(s);
    }
    if (fillings.empty() || others.empty()) continue;
    join_to_largest(given.segments, fillings, out);
    join_to_largest(given.segments, others, out);
  }
  return out;
}

std::vector<WallEvidence> gather_whole_walls(Segmentation& segmentation, double tolerance_m,
                                             const EvidenceSetting& setting, Task& task) {
  const Segmentation given = segmentation;
  const std::vector<uint32_t> whole = whole_walls(given, tolerance_m, task);
  segmentation = joined_pieces(given, whole, task);
  std::vector<WallEvidence> out = gather_evidence(segmentation, setting, task);
  const std::vector<uint32_t> apart = pieces_apart(given, whole, out, task);
  if (apart == whole) return out;
  std::vector<size_t> changed;
  for (size_t s = 0; s < whole.size(); ++s)
    if (apart[s] != whole[s])
      changed.push_back(s), changed.push_back(whole[s] - 1), changed.push_back(apart[s] - 1);
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  segmentation = joined_pieces(given, apart, task);
  look_at_planes(segmentation, changed, setting, out, task);
  tell_planes(segmentation, setting, out, task);
  return out;
}

}  // namespace jalon
