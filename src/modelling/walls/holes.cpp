// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/holes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kHolesSteep = 3;     // |dv| / |du| of a jamb
constexpr double kFeetLevel_m = 0.4;  // steps of sloping ground from foot to foot
constexpr size_t kMostEdges = 12;     // of a head between the jambs

bool goes_up(const Vec2& d) { return d.v > kHolesSteep * std::fabs(d.u); }
bool goes_down(const Vec2& d) { return -d.v > kHolesSteep * std::fabs(d.u); }

// The notch whose left jamb is edge `up` of the outline. Walking anticlockwise along the lower border a notch goes up,
// to the right along its head and down again; the right end of the face goes up and then to the left.
std::optional<WallHole> notch_at(const VectorRing& outline, size_t up,
                                 const NotchSetting& setting) {
  const size_t n = outline.corners.size();
  const auto corner = [&](size_t i) -> const Vec2& { return outline.corners[i % n]; };
  const Vec2 left = corner(up);
  if (!goes_up(corner(up + 1) - left)) return {};
  for (size_t k = 1; k <= std::min(kMostEdges, n - 2); ++k) {
    const Vec2 &from = corner(up + k), &right = corner(up + k + 1);
    const double height = std::min(corner(up + 1).v, from.v) - std::max(left.v, right.v);
    const double width = right.u - left.u;
    if (from.v <= left.v) return {};
    if (width <= 0 || !goes_down(right - from) || std::fabs(right.v - left.v) > kFeetLevel_m)
      continue;
    if (height < setting.min_height_m || width < setting.min_width_m || width > setting.max_width_m)
      return {};
    WallHole hole;
    hole.is_notch = true;
    // Anticlockwise as a face of its own: along the feet, then the face's way back.
    hole.outline.corners.push_back(left);
    hole.outline.edges.push_back({});
    for (size_t i = k + 1; i > 0; --i) {
      hole.outline.corners.push_back(corner(up + i));
      VectorEdge edge = outline.edges[(up + i - 1) % n];
      edge.sagitta_m = -edge.sagitta_m;
      hole.outline.edges.push_back(edge);
    }
    return hole;
  }
  return {};
}

// First index of a run of corners in a ring (cyclic), or the ring's size.
size_t find_run(const std::vector<Vec2>& ring, const std::vector<Vec2>& run) {
  for (size_t i = 0; i < ring.size(); ++i) {
    size_t k = 0;
    while (k < run.size() && ring[(i + k) % ring.size()] == run[k]) ++k;
    if (k == run.size()) return i;
  }
  return ring.size();
}

}  // namespace

std::vector<WallHole> holes_of(const VectorPlane& wall, const NotchSetting& setting) {
  std::vector<WallHole> out;
  for (size_t f = 0; f < wall.faces.size(); ++f)
    for (const VectorRing& ring : wall.faces[f].openings)
      out.push_back({reversed(ring), static_cast<uint32_t>(f), false});
  for (size_t f = 0; f < wall.faces.size(); ++f) {
    const size_t first = out.size();
    for (size_t i = 0; i < wall.faces[f].outline.corners.size(); ++i)
      if (auto notch = notch_at(wall.faces[f].outline, i, setting)) {
        notch->piece = static_cast<uint32_t>(f);
        out.push_back(std::move(*notch));
      }
    std::stable_sort(out.begin() + static_cast<ptrdiff_t>(first), out.end(),
                     [](const WallHole& a, const WallHole& b) {
                       return a.outline.corners.front().u < b.outline.corners.front().u;
                     });
  }
  return out;
}

void close_hole(VectorFace& face, const WallHole& hole) {
  if (!hole.is_notch) {
    const VectorRing ring = reversed(hole.outline);
    std::erase_if(face.openings, [&](const VectorRing& r) { return r.corners == ring.corners; });
    return;
  }
  // The face walks from the left foot over the head to the right foot.
  std::vector<Vec2> run(hole.outline.corners.rbegin(), hole.outline.corners.rend());
  std::rotate(run.begin(), run.end() - 1, run.end());
  VectorRing& outline = face.outline;
  const size_t n = outline.corners.size(), at = find_run(outline.corners, run);
  if (at == n || n < run.size() + 1) return;
  std::rotate(outline.corners.begin(), outline.corners.begin() + static_cast<ptrdiff_t>(at),
              outline.corners.end());
  std::rotate(outline.edges.begin(), outline.edges.begin() + static_cast<ptrdiff_t>(at),
              outline.edges.end());
  const auto inner = static_cast<ptrdiff_t>(run.size() - 2);
  outline.corners.erase(outline.corners.begin() + 1, outline.corners.begin() + 1 + inner);
  outline.edges.erase(outline.edges.begin(), outline.edges.begin() + inner);
  outline.edges.front() = {};
}

}  // namespace jalon
