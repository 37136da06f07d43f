// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/bays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kChordOfSpacing = 0.1;
// Smaller pieces of the wall lie in the openings (shutters, posters) unless they stand on its foot as piers do.
constexpr double kLeastPier_m2 = 1, kPierHeight_m = 1, kPierFoot_m = 0.5;
constexpr double kPierWidth_spacings = 3;  // on average: a string of points is no pier
constexpr double kSameGap =
    0.6;  // intersection over union of a gap in two rows: a bite in a pier is no end
constexpr double kBite_m = 1.0;  // nor is one that leaves nothing of it, so high
constexpr double kOnSide_spacings =
    3;  // a row agrees with a side from which its wall ends no farther
constexpr size_t kRecentRows = 15;
constexpr double kLintel = 0.5;          // share of the width that has wall above it
constexpr double kWalledUp = 0.5;        // of a bay with another wall behind it
constexpr double kSeenShare = 0.15;      // of a bay's cells with points behind it
constexpr double kHeadQuantile = 0.995;  // of their levels: a few strays lie higher
constexpr size_t kMostRows = 20000;
constexpr double kTakenUp = 0.3;  // of a bay by a hole

struct Interval {
  double from, to;
  double length() const { return to - from; }
};
using Row = std::vector<Interval>;

double common(const Interval& a, const Interval& b) {
  return std::max(0.0, std::min(a.to, b.to) - std::max(a.from, b.from));
}

/// Where the middles of level rows lie within the outlines of the wall's larger pieces.
struct Rows {
  double low_v = 0, step_m = 1;
  std::vector<Row> solid;

  double level(size_t k) const { return low_v + (static_cast<double>(k) + 0.5) * step_m; }
};

void add_outline(const std::vector<Vec2>& ring, Rows& rows) {
  std::vector<std::vector<double>> crossings(rows.solid.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a.v > b.v) std::swap(a, b);
    const double first = std::ceil((a.v - rows.low_v) / rows.step_m - 0.5);
    for (auto k = static_cast<size_t>(std::max(0.0, first));
         k < rows.solid.size() && rows.level(k) < b.v; ++k)
      crossings[k].push_back(a.u + (b.u - a.u) * (rows.level(k) - a.v) / (b.v - a.v));
  }
  for (size_t k = 0; k < crossings.size(); ++k) {
    std::sort(crossings[k].begin(), crossings[k].end());
    for (size_t i = 0; i + 1 < crossings[k].size(); i += 2)
      rows.solid[k].push_back({crossings[k][i], crossings[k][i + 1]});
  }
}

bool is_pier(const VectorRing& outline, double foot_v, double spacing_m) {
  const RingBox box = ring_box(outline);
  const double area = signed_area(outline);
  return area >= kLeastPier_m2 ||
         (box.height() >= kPierHeight_m && box.low.v <= foot_v + kPierFoot_m &&
          area >= kPierWidth_spacings * spacing_m * box.height());
}

Rows rows_of(const VectorPlane& wall) {
  Rows rows;
  RingBox box;
  for (const VectorFace& face : wall.faces) box.add(face.outline.corners);
  if (!(box.high.v > box.low.v)) return rows;
  rows.step_m = std::max(wall.spacing_m, box.height() / static_cast<double>(kMostRows));
  rows.low_v = box.low.v;
  rows.solid.resize(static_cast<size_t>(std::ceil(box.height() / rows.step_m)));
  for (const VectorFace& face : wall.faces)
    if (is_pier(face.outline, box.low.v, wall.spacing_m))
      add_outline(flattened(face.outline, kChordOfSpacing * wall.spacing_m), rows);
  for (Row& row : rows.solid)
    std::sort(row.begin(), row.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
  return rows;
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A gap followed upward.
struct Bay {
  size_t first = 0, end = 0;  ///< rows
  std::vector<size_t> rows;   ///< those that show it, with the ends of the wall on both sides
  std::vector<double> left, right;

  /// Where its sides were of late: one row may show a bar or a bite.
  Interval recent() const {
    const auto of = [](const std::vector<double>& side) {
      const auto n = static_cast<ptrdiff_t>(std::min(side.size(), kRecentRows));
      return quantile({side.end() - n, side.end()}, 0.5);
    };
    return {of(left), of(right)};
  }
};

Row gaps_of(const Row& solid, const NotchSetting& setting) {
  Row out;
  double end = solid.empty() ? 0 : solid.front().to;
  for (const Interval& piece : solid) {
    const double width = piece.from - end;
    if (width >= setting.min_width_m && width <= setting.max_width_m)
      out.push_back({end, piece.from});
    end = std::max(end, piece.to);
  }
  return out;
}

std::vector<Bay> follow_gaps(const Rows& rows, const NotchSetting& setting) {
  const auto longest_bite = static_cast<size_t>(kBite_m / rows.step_m);
  std::vector<Bay> open, done;
  for (size_t k = 0; k < rows.solid.size(); ++k) {
    for (const Interval& gap : gaps_of(rows.solid[k], setting)) {
      const auto same = [&](const Bay& bay) {
        if (bay.end > k) return false;
        const Interval recent = bay.recent();
        const double both = common(recent, gap);
        return both >= kSameGap * (recent.length() + gap.length() - both);
      };
      auto it = std::find_if(open.begin(), open.end(), same);
      if (it == open.end()) it = open.insert(open.end(), Bay{k, k, {}, {}, {}});
      it->rows.push_back(k);
      it->left.push_back(gap.from);
      it->right.push_back(gap.to);
      it->end = k + 1;
    }
    const auto ended = std::stable_partition(
        open.begin(), open.end(), [&](const Bay& bay) { return k + 1 - bay.end <= longest_bite; });
    done.insert(done.end(), ended, open.end());
    open.erase(ended, open.end());
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

/// The median of each side; rows below and above that agree with neither (the place of a sign board over the piers) are
/// not of the bay.
Interval settle_sides(Bay& bay, double reach_m) {
  const Interval width{quantile(bay.left, 0.5), quantile(bay.right, 0.5)};
  size_t first = bay.rows.size(), last = 0;
  for (size_t i = 0; i < bay.rows.size(); ++i)
    if (std::fabs(bay.left[i] - width.from) <= reach_m ||
        std::fabs(bay.right[i] - width.to) <= reach_m) {
      first = std::min(first, i);
      last = i;
    }
  bay.first = bay.rows[std::min(first, last)];
  bay.end = bay.rows[last] + 1;
  return width;
}

/// Whether there is wall over most of the bay somewhere above it.
bool has_lintel(const Rows& rows, const Bay& bay, const Interval& width) {
  for (size_t k = bay.end; k < rows.solid.size(); ++k) {
    double covered = 0;
    for (const Interval& piece : rows.solid[k]) covered += common(piece, width);
    if (covered >= kLintel * width.length()) return true;
  }
  return false;
}

/// The piece whose border is the bay's left side.
uint32_t piece_beside(const VectorPlane& wall, const Vec2& left) {
  uint32_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t f = 0; f < wall.faces.size(); ++f)
    for (const Vec2& corner : wall.faces[f].outline.corners)
      if (norm(corner - left) < nearest)
        nearest = norm(corner - left), best = static_cast<uint32_t>(f);
  return best;
}

VectorRing rectangle(const Interval& width, const Interval& height, double sigma_m) {
  VectorRing ring;
  ring.corners = {{width.from, height.from},
                  {width.to, height.from},
                  {width.to, height.to},
                  {width.from, height.to}};
  for (const EdgeDirection d : {EdgeDirection::kHorizontal, EdgeDirection::kVertical,
                                EdgeDirection::kHorizontal, EdgeDirection::kVertical}) {
    VectorEdge edge;
    edge.direction = d;
    if (d == EdgeDirection::kVertical) edge.sigma_m = sigma_m;
    ring.edges.push_back(edge);
  }
  return ring;
}

bool is_taken_up(const VectorRing& bay, std::span<const WallHole> holes) {
  const RingBox a = ring_box(bay);
  return std::any_of(holes.begin(), holes.end(), [&](const WallHole& hole) {
    const RingBox b = ring_box(hole.outline);
    const double u = common({a.low.u, a.high.u}, {b.low.u, b.high.u});
    const double v = common({a.low.v, a.high.v}, {b.low.v, b.high.v});
    return u * v > kTakenUp * a.width() * a.height();
  });
}

}  // namespace

std::vector<WallHole> bays_of(const VectorPlane& wall, std::span<const WallHole> holes,
                              const NotchSetting& setting) {
  std::vector<WallHole> out;
  const Rows rows = rows_of(wall);
  for (Bay& bay : follow_gaps(rows, setting)) {
    const Interval width = settle_sides(bay, kOnSide_spacings * wall.spacing_m);
    const Interval height{rows.low_v + static_cast<double>(bay.first) * rows.step_m,
                          rows.low_v + static_cast<double>(bay.end) * rows.step_m};
    if (height.length() < setting.min_height_m || !(width.length() >= setting.min_width_m))
      continue;
    if (!has_lintel(rows, bay, width)) continue;
    WallHole hole;
    hole.outline = rectangle(width, height, wall.spacing_m);
    hole.piece = piece_beside(wall, hole.outline.corners[0]);
    hole.is_notch = hole.is_bay = true;
    if (!is_taken_up(hole.outline, holes)) out.push_back(std::move(hole));
  }
  std::stable_sort(out.begin(), out.end(), [](const WallHole& a, const WallHole& b) {
    return a.outline.corners[0].u < b.outline.corners[0].u;
  });
  return out;
}

bool is_walled_up(const WallHole& bay, const VectorPlane& wall, const VectorPlane& other,
                  double max_depth_m) {
  const RingBox box = ring_box(bay.outline);
  for (const VectorFace& face : other.faces) {
    RingBox place;
    double depth_m = 0;
    for (const Vec2& corner : face.outline.corners) {
      const Vec3 at = other.frame.lift(corner);
      place.add(wall.frame.project(at));
      depth_m -= dot(at - wall.frame.origin, wall.frame.normal) - wall.frame.height;
    }
    depth_m /= static_cast<double>(face.outline.corners.size());
    const double u = common({box.low.u, box.high.u}, {place.low.u, place.high.u});
    const double v = common({box.low.v, box.high.v}, {place.low.v, place.high.v});
    if (depth_m > 0 && depth_m <= max_depth_m && u * v > kWalledUp * box.width() * box.height())
      return true;
  }
  return false;
}

bool fit_to_content(WallHole& bay, const HoleSurvey& survey, const WallMap& map,
                    double tolerance_m) {
  const RingBox box = ring_box(bay.outline);
  std::vector<double> levels;
  std::vector<std::pair<uint32_t, uint32_t>> cells;
  for (const HolePoint& p : survey.points) {
    if (p.w > -tolerance_m || !box.holds({p.u, p.v})) continue;
    levels.push_back(p.v);
    cells.emplace_back(static_cast<uint32_t>((p.u - map.origin.u) / map.cell_m),
                       static_cast<uint32_t>((p.v - map.origin.v) / map.cell_m));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  if (static_cast<double>(cells.size()) < kSeenShare * survey.cells) return false;
  const double head = quantile(std::move(levels), kHeadQuantile);
  for (Vec2& corner : bay.outline.corners)
    if (corner.v > head) corner.v = head;
  return true;
}

}  // namespace jalon
