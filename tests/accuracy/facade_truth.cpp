// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "facade_truth.h"

#include <iomanip>
#include <optional>

#include "area_pieces.h"

namespace jalon::test {

namespace {

constexpr double kParallel = 0.9986;  // cosine of 3 degrees
constexpr double kRow_m = 0.005;      // of openings
constexpr double kAreaCell_m = 0.02;  // of wall areas
constexpr double kSameCorner_spacings = 5,
                 kLevel_rad = 0.09;  // where an arc goes on without a corner
constexpr double kDeepWall_m = 0.3;  // an opening of a wall this far before or behind is another's
constexpr double kUnwantedIou = 0.3;

WallAxes axes_of(const FacadeTruth& truth) {
  WallAxes axes;
  const TruthWall& wall = truth.walls.at(0);
  axes.origin = wall.origin;
  axes.u = wall.along, axes.v = wall.up, axes.n = wall.normal;
  return axes;
}

double out_of(const TruthWall& wall, const WallAxes& axes) { return axes.height_m(wall.origin); }

double mean_height(const Drawn& ring) {
  double sum = 0;
  for (const double h : ring.heights_m) sum += h;
  return sum / static_cast<double>(ring.heights_m.size());
}

bool is_opening_word(const std::string& word) {
  for (const char* known :
       {"window", "door", "opening", "gateway", "shop_front", "vent", "other", "recess"})
    if (word == known) return true;
  return false;
}

/// The part itself or its parent where that is an opening.
std::optional<uint32_t> opening_of(const Model& model, uint32_t part) {
  if (is_opening_word(model.parts[part].part_class)) return part;
  const uint64_t parent = model.parts[part].parent;
  if (parent != kNoParent && is_opening_word(model.parts[parent].part_class))
    return static_cast<uint32_t>(parent);
  return {};
}

/// Height of the wall that an opening's part belongs to.
double wall_height(const Model& model, uint32_t part, const std::vector<double>& heights,
                   double otherwise) {
  for (uint64_t p = part; p != kNoParent; p = model.parts[p].parent)
    if (!std::isnan(heights[p])) return heights[p];
  return otherwise;
}

/// Whether a point lies in the shapes, row by row of cells.
class Cells {
 public:
  Cells(const Extent2& extent, double cell_m)
      : low_(extent.low),
        cell_m_(cell_m),
        columns_(static_cast<size_t>(std::ceil((extent.high.u - low_.u) / cell_m))),
        rows_(static_cast<size_t>(std::ceil((extent.high.v - low_.v) / cell_m))) {}
  size_t size() const { return columns_ * rows_; }
  std::string pieces(const std::string& what, std::span<const uint32_t> of) const {
    return text_of_pieces(what, of, static_cast<uint32_t>(columns_), static_cast<uint32_t>(rows_),
                          low_, cell_m_);
  }
  Vec2 middle(size_t c) const {
    return low_ + Vec2{(static_cast<double>(c % columns_) + 0.5) * cell_m_,
                       (static_cast<double>(c / columns_) + 0.5) * cell_m_};
  }
  void mark(const Region& region, std::vector<char>& cells) const {
    const auto crossings = crossings_of(region, low_.v, cell_m_, rows_);
    for (size_t row = 0; row < rows_; ++row)
      for (size_t i = 0; i + 1 < crossings[row].size(); i += 2) {
        const auto column = [&](double u) {
          return static_cast<size_t>(std::clamp(std::ceil((u - low_.u) / cell_m_ - 0.5), 0.0,
                                                static_cast<double>(columns_)));
        };
        for (size_t c = column(crossings[row][i]); c < column(crossings[row][i + 1]); ++c)
          cells[row * columns_ + c] = 1;
      }
  }
  std::vector<char> marked(const Region& region) const {
    std::vector<char> cells(size(), 0);
    mark(region, cells);
    return cells;
  }

 private:
  Vec2 low_;
  double cell_m_;
  size_t columns_, rows_;
};

void compare_areas(const FoundFacade& found, const FacadeTruth& truth, FacadeFigures& out) {
  const WallAxes axes = axes_of(truth);
  Extent2 extent;
  for (const TruthWall& wall : truth.walls) extent.add(drawn(wall.outline).region);
  for (const FoundFacade::Face& face : found.walls) extent.add(Region{face.shape});
  const Cells cells(extent, kAreaCell_m);
  const double cell_m2 = kAreaCell_m * kAreaCell_m;
  // 1. Of each true wall: where it is, where openings of any use are, what may be either.
  std::vector<std::vector<char>> wall_cells;
  std::vector<char> filled_ok(cells.size(), 0);
  for (size_t w = 0; w < truth.walls.size(); ++w) {
    const TruthWall& wall = truth.walls[w];
    wall_cells.push_back(cells.marked(drawn(wall.outline).region));
    Region open, either;
    for (const TruthOpening& o : truth.openings) {
      if (o.wall != w) continue;
      const Region region = drawn(o.contour).region;
      open.insert(open.end(), region.begin(), region.end());
      if (areas(region, region, kRow_m).a_m2 < kFillLimit_m2)
        either.insert(either.end(), region.begin(), region.end());
    }
    for (const TruthWall::Cover& cover : wall.covers) {
      Shape shape = drawn(cover.outline).region[0];
      for (const TruthContour& hole : cover.holes)
        shape.rings.push_back(drawn(hole).region[0].rings[0]);
      either.push_back(shape);
    }
    if (!open.empty()) {
      const std::vector<char> holes = cells.marked(open);
      for (size_t c = 0; c < cells.size(); ++c)
        if (holes[c] != 0) wall_cells[w][c] = 0;
    }
    if (!either.empty()) cells.mark(either, filled_ok);
  }
  // 2. The model's faces where no wall of their plane is.
  for (const FoundFacade::Face& face : found.walls) {
    const std::vector<char> own = cells.marked({face.shape});
    double nearest_m = kDeepWall_m;
    for (const TruthWall& wall : truth.walls)
      nearest_m = std::min(nearest_m, std::fabs(out_of(wall, axes) - face.out_m));
    const bool is_near = nearest_m < kDeepWall_m;
    double& taken_m2 = is_near ? out.invented_m2 : out.elsewhere_m2;
    std::vector<uint32_t> taken;
    for (size_t c = 0; c < cells.size(); ++c) {
      if (own[c] == 0 || filled_ok[c] != 0) continue;
      bool is_wall = false;
      for (size_t w = 0; w < truth.walls.size(); ++w)
        is_wall = is_wall || (wall_cells[w][c] != 0 && std::fabs(out_of(truth.walls[w], axes) -
                                                                 face.out_m) <= kFacadePlane_m);
      if (is_wall) continue;
      taken_m2 += cell_m2;
      taken.push_back(static_cast<uint32_t>(c));
    }
    out.notes += cells.pieces(is_near ? "wall invented" : "wall elsewhere", taken);
  }
  // 3. The walls where no face of the model is.
  for (size_t w = 0; w < truth.walls.size(); ++w) {
    std::vector<char> has(cells.size(), 0);
    for (const FoundFacade::Face& face : found.walls)
      if (std::fabs(out_of(truth.walls[w], axes) - face.out_m) <= kFacadePlane_m)
        cells.mark({face.shape}, has);
    std::vector<uint32_t> lost;
    for (size_t c = 0; c < cells.size(); ++c) {
      if (wall_cells[w][c] == 0 || filled_ok[c] != 0) continue;
      out.wall_m2 += cell_m2;
      if (truth.walls[w].raster.at(cells.middle(c)) != Sight::kSeen) continue;
      out.wall_seen_m2 += cell_m2;
      if (has[c] != 0) continue;
      out.lost_m2 += cell_m2;
      lost.push_back(static_cast<uint32_t>(c));
    }
    out.notes += cells.pieces("wall lost", lost);
  }
}

/// The corners of a contour: not where arcs go on, nor where it stands on the ground.
std::vector<Vec2> corners_of(const TruthOpening& o) {
  const TruthContour& c = o.contour;
  const size_t n = c.size();
  double foot = c[0].at.v;
  for (const TruthCorner& corner : c) foot = std::min(foot, corner.at.v);
  // The way of an edge at its start or its end.
  const auto heading = [&](size_t k, bool at_end) {
    const Vec2 d = c[(k + 1) % n].at - c[k].at;
    const double turn = 2 * std::atan2(2 * c[k].sagitta_m, norm(d));
    return std::atan2(d.v, d.u) + (at_end ? turn : -turn);
  };
  std::vector<Vec2> out;
  for (size_t k = 0; k < n; ++k) {
    const double turn = heading(k, false) - heading((k + n - 1) % n, true);
    const double bend = std::fabs(std::remainder(turn, 6.283185307179586));
    if (bend < kLevel_rad || (o.touches_ground && c[k].at.v == foot)) continue;
    out.push_back(c[k].at);
  }
  return out;
}

void compare_corners(const TruthOpening& truth, const FoundOpening& found, FacadeFigures& out) {
  for (const Vec2& p : corners_of(truth)) {
    double nearest = kSameCorner_spacings;
    for (const Vec2& q : found.drawn.corners)
      nearest = std::min(nearest, norm(q - p) / truth.spacing_m);
    ++out.corners;
    if (nearest >= kSameCorner_spacings) continue;
    ++out.paired;
    out.corner_squares += nearest * nearest;
  }
}

struct Pair {
  double iou;
  size_t mine, other;
};

/// All true openings and the model's that lie over each other, the best first; each once.
std::vector<Pair> pairs_of(const FoundFacade& found, const FacadeTruth& truth,
                           const std::vector<Region>& regions) {
  const WallAxes axes = axes_of(truth);
  std::vector<Pair> all, out;
  for (size_t t = 0; t < truth.openings.size(); ++t) {
    const double out_m = out_of(truth.walls[truth.openings[t].wall], axes);
    for (size_t f = 0; f < found.openings.size(); ++f) {
      const FoundOpening& o = found.openings[f];
      if (std::fabs(o.out_m - out_m) > kDeepWall_m) continue;
      if (!extent_of(regions[t]).meets(extent_of(o.drawn.region))) continue;
      const double iou = areas(regions[t], o.drawn.region, kRow_m).iou();
      if (iou >= kUnwantedIou) all.push_back({iou, t, f});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Pair& a, const Pair& b) { return a.iou > b.iou; });
  std::vector<bool> taken(truth.openings.size(), false), used(found.openings.size(), false);
  for (const Pair& p : all) {
    if (taken[p.mine] || used[p.other]) continue;
    taken[p.mine] = used[p.other] = true;
    out.push_back(p);
  }
  return out;
}

}  // namespace

bool is_wanted(const TruthOpening& o) {
  return o.width_spacings > kWantedSpacings &&
         std::min(o.area_seen_share, o.outline_seen_share) >= kWantedSeen;
}

Drawn drawn(const TruthContour& contour) {
  Drawn out;
  std::vector<Vec2> chords;
  for (size_t k = 0; k < contour.size(); ++k) {
    const Vec2 &a = contour[k].at, &b = contour[(k + 1) % contour.size()].at;
    out.corners.push_back(a);
    out.heights_m.push_back(0);
    if (contour[k].sagitta_m == 0) chords.push_back(b);
    else append_chords(chords, a, b, contour[k].sagitta_m, out.arcs.emplace_back());
  }
  out.region = {{{chords}}};
  return out;
}

FoundFacade found_facade(const Model& model, const FacadeTruth& truth) {
  const WallAxes axes = axes_of(truth);
  FoundFacade out;
  std::vector<double> heights(model.parts.size(), kNaN);  // of the walls
  std::vector<bool> has_ring(model.parts.size(), false);
  // 1. Walls, and their holes that are openings.
  for (const Face& face : model.faces) {
    const Part& part = model.parts[face.part];
    if (part.part_class != part_class::kWall) continue;
    if (std::fabs(dot(axes.n, face.plane.normal)) < kParallel) continue;
    const bool same_side = dot(axes.n, face.plane.normal) > 0;
    const Drawn outline = drawn(model, model.rings[face.first_ring], same_side, axes);
    const double out_m = mean_height(outline);
    heights[face.part] = out_m;
    Shape shape = outline.region[0];
    for (uint64_t k = 1; k < face.ring_count; ++k) {
      const Ring& ring = model.rings[face.first_ring + k];
      Drawn hole = drawn(model, ring, same_side, axes);
      shape.rings.push_back(hole.region[0].rings[0]);
      const std::string word = ring.part == kNoPart ? "" : model.parts[ring.part].part_class;
      if (ring.part != kNoPart) has_ring[ring.part] = true;
      if (ring.part != kNoPart && !is_opening_word(word)) continue;
      out.openings.push_back({word, std::move(hole), out_m});
    }
    out.walls.push_back({std::move(shape), out_m});
  }
  // 2. Openings at the border of their wall: a face of their own, and no hole.
  for (const Face& face : model.faces) {
    const std::optional<uint32_t> opening = opening_of(model, face.part);
    if (!opening || has_ring[*opening]) continue;
    if (std::fabs(dot(axes.n, face.plane.normal)) < kParallel) continue;
    has_ring[*opening] = true;
    Drawn pane =
        drawn(model, model.rings[face.first_ring], dot(axes.n, face.plane.normal) > 0, axes);
    const double out_m = wall_height(model, *opening, heights, mean_height(pane));
    out.openings.push_back({model.parts[*opening].part_class, std::move(pane), out_m});
  }
  return out;
}

FacadeFigures compare_facade(const FoundFacade& found, const FacadeTruth& truth) {
  FacadeFigures out;
  out.facades = 1;
  std::vector<Region> regions;
  for (const TruthOpening& o : truth.openings) regions.push_back(drawn(o.contour).region);
  std::vector<bool> is_found(truth.openings.size(), false), is_right(found.openings.size(), false),
      is_free(found.openings.size(), false);
  // 1. Openings found, of which class, and how they are drawn.
  for (const Pair& p : pairs_of(found, truth, regions)) {
    const TruthOpening& mine = truth.openings[p.mine];
    const FoundOpening& other = found.openings[p.other];
    if (!is_wanted(mine)) {
      is_free[p.other] = true;
      continue;
    }
    if (p.iou < kMatchIou) continue;
    is_found[p.mine] = is_right[p.other] = true;
    out.ious.push_back(p.iou);
    if (other.is_certain()) {
      ++out.certain;
      out.class_right += other.part_class == name_of(mine.opening_class);
    }
    if (mine.outline_seen_share >= kWellSeen) compare_corners(mine, other, out);
    bool is_straight = true;
    for (const TruthCorner& c : mine.contour) is_straight = is_straight && c.sagitta_m == 0;
    out.straight += is_straight;
    out.round += !is_straight;
    (is_straight ? out.false_arcs : out.round_drawn) += !other.drawn.arcs.empty();
  }
  // 2. What is missing, and what is invented.
  for (size_t t = 0; t < truth.openings.size(); ++t) {
    if (!is_wanted(truth.openings[t])) continue;
    ++out.wanted;
    out.found += is_found[t];
    if (!is_found[t])
      out.notes += std::string("\n    missed ") + name_of(truth.openings[t].opening_class) + " " +
                   text_of_extent(regions[t]);
  }
  for (size_t f = 0; f < found.openings.size(); ++f) {
    if (is_free[f]) continue;
    ++out.judged;
    out.right += is_right[f];
    if (!is_right[f])
      out.notes += "\n    wrong " + found.openings[f].part_class + " " +
                   text_of_extent(found.openings[f].drawn.region);
  }
  // 3. Walls.
  compare_areas(found, truth, out);
  return out;
}

double FacadeFigures::median_iou() const {
  if (ious.empty()) return 0;
  std::vector<double> sorted = ious;
  const auto middle = sorted.begin() + static_cast<ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

FacadeFigures& FacadeFigures::operator+=(const FacadeFigures& o) {
  facades += o.facades;
  wanted += o.wanted, found += o.found, judged += o.judged, right += o.right;
  ious.insert(ious.end(), o.ious.begin(), o.ious.end());
  certain += o.certain, class_right += o.class_right;
  wall_m2 += o.wall_m2, invented_m2 += o.invented_m2, elsewhere_m2 += o.elsewhere_m2;
  wall_seen_m2 += o.wall_seen_m2, lost_m2 += o.lost_m2;
  corners += o.corners, paired += o.paired, corner_squares += o.corner_squares;
  straight += o.straight, false_arcs += o.false_arcs;
  round += o.round, round_drawn += o.round_drawn;
  notes += o.notes;
  return *this;
}

std::string heads_of_rows() {
  return "kind         facades wanted recall  prec. med.IoU  class  invent.% elsewh.%  lost% "
         "corner RMS  "
         "(paired)"
         " false arcs  arcs";
}

std::string row_of(const std::string& name, const FacadeFigures& f) {
  std::ostringstream out;
  out << std::fixed << std::left << std::setw(12) << name << std::right << std::setw(8) << f.facades
      << std::setw(7) << f.wanted << std::setprecision(3) << std::setw(7) << f.recall()
      << std::setw(7) << f.precision() << std::setw(8) << f.median_iou() << std::setw(7)
      << f.class_share() << std::setprecision(2) << std::setw(10) << 100 * f.invented_share()
      << std::setw(9) << 100 * f.elsewhere_share() << std::setw(7) << 100 * f.lost_share()
      << std::setw(11) << f.corner_rms() << std::setw(6) << f.paired << "/" << std::left
      << std::setw(6) << f.corners << std::right << std::setw(4) << f.false_arcs << "/" << std::left
      << std::setw(6) << f.straight << std::right << std::setw(4) << f.round_drawn << "/"
      << f.round;
  return out.str();
}

}  // namespace jalon::test
