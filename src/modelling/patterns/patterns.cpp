// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/patterns.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.h"
#include "modelling/patterns/candidate.h"
#include "modelling/patterns/grid.h"
#include "modelling/patterns/place.h"
#include "modelling/patterns/site.h"
#include "modelling/patterns/types.h"
#include "modelling/walls/sills.h"

namespace jalon {

namespace {

constexpr double kReach =
    1.5;  // local spacings: border points farther from a side do not belong to it
constexpr double kFit = 0.6;  // local spacings: root mean square distance of those that do
constexpr double kExplained =
    0.65;  // share of an opening's border points that belong to the sides of a copy
constexpr double kSideSupport = 0.10;  // share of a side's length where border points must lie
constexpr size_t kLeastSupport = 3;
constexpr double kSideSigmas = 3;  // of the mean distance of a side's points
// Sides seen and lines of the grid agreed with. Three sides prove one size; a form seen once needs row and column as
// well: among many single openings one that agrees by chance in one size is soon found.
constexpr size_t kLeastSigns = 3, kLeastSignsOfOne = 4;
constexpr double kOddOne =
    2;  // parameters that a window unlike the others of its row must be worth
constexpr size_t kMostBorderPoints = 400;  // of a fit; more are thinned evenly

/// Whether any of its edges stands upright or lies level: then all of its kind do.
bool is_upright(const VectorRing& ring) {
  return std::any_of(ring.edges.begin(), ring.edges.end(), [](const VectorEdge& edge) {
    return edge.direction == EdgeDirection::kVertical ||
           edge.direction == EdgeDirection::kHorizontal;
  });
}

/// Shifts to start from: both ends and the middle, or the middle alone where they are near each other.
std::vector<double> starts(double low, double high, double reach_m) {
  const double middle = (low + high) / 2;
  return std::fabs(high - low) <= reach_m ? std::vector{middle} : std::vector{low, middle, high};
}

class Completion {
 public:
  Completion(FacadeWall& wall, const PatternSetting& setting) : wall_(wall), setting_(setting) {
    patterns_ = find_patterns(wall, setting);
    for (const FacadeOpening& o : wall.openings) boxes_.push_back(ring_box(o.outline));
    is_member_.assign(wall.openings.size(), false);
    for (const Pattern& p : patterns_)
      for (const size_t i : p.members) is_member_[i] = true;
  }

  size_t run() {
    if (patterns_.empty()) return 0;
    look_for_grid();
    size_t copies = 0;
    for (size_t i = 0; i < is_member_.size(); ++i)
      if (!is_member_[i]) copies += replace(i);
    look_for_grid();
    return copies + fill_gaps();
  }

 private:
  void look_for_grid() {
    std::vector<size_t> known;
    for (size_t i = 0; i < wall_.openings.size(); ++i)
      if (is_member_[i]) known.push_back(i);
    grid_ = find_grid(wall_, known, boxes_, setting_);
  }

  const FacadeOpening& best_of(size_t pattern) const {
    return wall_.openings[patterns_[pattern].best];
  }

  /// 2. The badly measured opening becomes a copy of the pattern that its border agrees with best.
  size_t replace(size_t i) {
    PatternCandidate best;
    for (size_t p = 0; p < patterns_.size(); ++p) {
      PatternCandidate c = best_placement(p, i);
      if (c.is_likelier_than(best)) best = std::move(c);
    }
    if (best.signs == 0) best = at_crossing(i);
    if (best.signs == 0 || explains_itself_better(i, best)) return 0;
    FacadeOpening& opening = wall_.openings[i];
    const FacadeOpening& source = best_of(best.pattern);
    opening.outline = moved(source.outline, best.motion);
    if (!std::isfinite(opening.depth_m))
      opening.depth_m = source.depth_m, opening.depth_sigma_m = source.depth_sigma_m;
    opening.kind = source.kind;
    opening.residual_m = best.residual_m;
    mark(i, best.pattern);
    return 1;
  }

  /// The pattern of the grid's crossing that lies in a hole, where its border is too torn to place it.
  PatternCandidate at_crossing(size_t i) const {
    PatternCandidate best;
    for (const GridLine& row : grid_.rows)
      for (const GridLine& column : grid_.columns) {
        const Vec2 centre{column.at, row.at};
        const size_t p =
            boxes_[i].holds(centre) ? pattern_at(patterns_, row, column) : patterns_.size();
        if (p == patterns_.size()) continue;
        const Vec2 pivot = patterns_[p].box.middle();
        const double spacing_m = spacing_beside(wall_, boxes_[i]);
        const auto settled = settled_on_sill(p, i, spacing_m, {pivot, centre - pivot, 0});
        if (!settled || !is_free(p, *settled, i)) continue;
        const Motion2& motion = *settled;
        const std::vector<Vec2> form = outline_points(moved(best_of(p).outline, motion));
        std::vector<Vec2> border = border_of(p, motion, i, spacing_m);
        const double cost_m2 = cost_in_place(form, border, kReach * spacing_m);
        PatternCandidate c{p, motion, 2, std::sqrt(cost_m2), cost_m2, std::move(border), 0};
        if (c.is_likelier_than(best)) best = std::move(c);
      }
    return best;
  }

  /// Whether the opening's own outline tells so much more about its border than the copy.
  bool explains_itself_better(size_t i, const PatternCandidate& copy) const {
    const FacadeOpening& opening = wall_.openings[i];
    const double reach_m = kReach * spacing_beside(wall_, boxes_[i]);
    const double own_m2 = cost_in_place(outline_points(opening.outline), copy.border, reach_m);
    double parameters =
        0;  // a place and a direction an edge; arcs, and edges in a class, have one more or less
    for (const VectorEdge& edge : opening.outline.edges)
      parameters += edge.sagitta_m != 0 ? 3 : edge.direction == EdgeDirection::kInclined ? 2 : 1;
    return is_better_explained(copy, own_m2, parameters);
  }

  void mark(size_t i, size_t pattern) {
    wall_.openings[i].evidence = Evidence::kCopied;
    wall_.openings[i].copied_from = static_cast<int32_t>(patterns_[pattern].best);
    boxes_[i] = ring_box(wall_.openings[i].outline);
    is_member_[i] = true;
    patterns_[pattern].members.push_back(i);
  }

  /// The pattern laid onto the border points of an opening, from each way its box can lie in that of the opening. The
  /// hole in the wall's points is as large as the opening at least.
  PatternCandidate best_placement(size_t p, size_t i) const {
    const FacadeOpening& opening = wall_.openings[i];
    const double reach_m = kReach * spacing_beside(wall_, boxes_[i]);
    if (opening.border_points.empty() || boxes_[i].width() < patterns_[p].box.width() - reach_m ||
        boxes_[i].height() < patterns_[p].box.height() - reach_m)
      return {};
    const std::vector<Vec2> form = outline_points(best_of(p).outline),
                            border = thinned_border(opening);
    // Where leaves or glass thin the points out, the last ones stay farther from the edge.
    const double spacing_m = spacing_beside(wall_, boxes_[i]);
    const double set_back_m =
        mean_distance(form, thinned_border(best_of(p))) * spacing_m / wall_.spacing_m;
    const bool may_turn = !is_upright(best_of(p).outline);
    PatternCandidate best;
    const Vec2 low = boxes_[i].low - patterns_[p].box.low,
               high = boxes_[i].high - patterns_[p].box.high;
    for (const double u : starts(low.u, high.u, reach_m))
      for (const double v : starts(low.v, high.v, reach_m)) {
        Placement placed = place_on_border(form, set_back_m, border, {u, v}, reach_m, may_turn);
        std::vector<Vec2> own = border_of(p, placed.motion, i, spacing_m);
        if (own.size() < border.size())
          placed = place_on_border(form, set_back_m, own, placed.motion.shift, reach_m, may_turn);
        PatternCandidate c = judged(p, i, placed, own.size(), spacing_m);
        c.border = std::move(own);
        if (c.is_likelier_than(best)) best = std::move(c);
      }
    return best;
  }

  std::vector<Vec2> thinned_border(const FacadeOpening& opening) const {
    const size_t n = opening.border_points.size(), step = n / kMostBorderPoints + 1;
    std::vector<Vec2> out;
    for (size_t k = 0; k < n; k += step) out.push_back(opening.border_points[k]);
    return out;
  }

  /// Border points of an opening that a copy there can explain: where a sill must hide the wall at its foot, but was
  /// not told, those there are the sill's.
  std::vector<Vec2> border_of(size_t p, const Motion2& motion, size_t i, double spacing_m) const {
    std::vector<Vec2> out = thinned_border(wall_.openings[i]);
    if (!best_of(p).ends_at_sill || wall_.openings[i].ends_at_sill) return out;
    const double foot_v = motion.point(patterns_[p].box.low).v;
    std::erase_if(out, [&](const Vec2& b) {
      return b.v < foot_v + spacing_m && b.v > foot_v - kMostSillHeight_m;
    });
    return out;
  }

  /// Counts the sides that are seen and the lines of the grid that the placement agrees with, and takes from the grid
  /// what the sides leave open. No signs: not there.
  PatternCandidate judged(size_t p, size_t i, const Placement& placed, size_t border_points,
                          double spacing_m) const {
    const RingBox& box = patterns_[p].box;
    std::array<bool, 4> seen{};
    for (size_t s = 0; s < 4; ++s) {
      const double length_m = s == kLeft || s == kRight ? box.height() : box.width();
      const auto wanted = static_cast<size_t>(kSideSupport * length_m / spacing_m);
      seen[s] =
          placed.sides[s] >= std::max(kLeastSupport, std::min(wanted, kMostBorderPoints / 20));
    }
    PatternCandidate out{p, placed.motion, 0, placed.residual_m, placed.cost_m2, {}, 2};
    const auto border = static_cast<double>(border_points);
    if (static_cast<double>(placed.support) < kExplained * border) return out;
    if (placed.residual_m > kFit * spacing_m || !is_of_size(placed, seen, spacing_m)) return out;
    size_t signs = static_cast<size_t>(std::count(seen.begin(), seen.end(), true));
    const double reach_m = 2 * grid_reach_m(wall_, setting_);
    const auto settled = settled_on_sill(p, i, spacing_m, out.motion);
    if (!settled) return out;
    out.motion = *settled;
    if (wall_.openings[i].ends_at_sill && !seen[kLower]) seen[kLower] = true, ++signs;
    const Vec2 centre = out.motion.point(box.middle());
    const GridLine* row = grid_.row_near(centre.v, reach_m);
    const GridLine* column = grid_.column_near(centre.u, reach_m);
    if (row == nullptr && !seen[kLower] && !seen[kUpper]) return out;
    if (column == nullptr && !seen[kLeft] && !seen[kRight]) return out;
    const double across_m2 = variance_across(placed, seen, kLeft, kRight, spacing_m);
    const double up_m2 = variance_across(placed, seen, kLower, kUpper, spacing_m);
    out.motion.shift.u += step_to_line(grid_, column, centre.u, across_m2);
    if (!wall_.openings[i].ends_at_sill)
      out.motion.shift.v += step_to_line(grid_, row, centre.v, up_m2);
    const bool is_single = patterns_[p].members.size() < 2;
    if (is_single && (row == nullptr || column == nullptr)) return out;
    const size_t lines =
        static_cast<size_t>(row != nullptr) + static_cast<size_t>(column != nullptr);
    signs += lines;
    out.parameters -= static_cast<double>(lines);
    if (lines == 2 && pattern_at(patterns_, *row, *column) != p) out.parameters += kOddOne;
    if (signs >= (is_single ? kLeastSignsOfOne : kLeastSigns) && is_free(p, out.motion, i))
      out.signs = signs;
    return out;
  }

  /// With the copy's foot on the sill that the opening ends at: it hides the wall below and is
  /// measured better than any border. Nothing when it lies elsewhere.
  std::optional<Motion2> settled_on_sill(size_t p, size_t i, double spacing_m,
                                         Motion2 motion) const {
    if (!wall_.openings[i].ends_at_sill) return motion;
    const double rise = boxes_[i].low.v - motion.point(patterns_[p].box.low).v;
    if (std::fabs(rise) > kReach * spacing_m) return std::nullopt;
    motion.shift.v += rise;
    return motion;
  }

  /// Whether the border lies where the form says on every side that is seen, within the tolerance of sizes.
  bool is_of_size(const Placement& placed, const std::array<bool, 4>& seen,
                  double spacing_m) const {
    for (size_t s = 0; s < 4; ++s) {
      const double sigma_m =
          placed.residual_m / std::sqrt(static_cast<double>(std::max<size_t>(1, placed.sides[s])));
      // How much farther the last points stay in the shade is known to within the growth of the spacing.
      const double limit_m = std::max(setting_.size_tolerance_m / 2, kSideSigmas * sigma_m) +
                             spacing_m - wall_.spacing_m;
      if (seen[s] && std::fabs(placed.offsets_m[s]) > limit_m) return false;
    }
    return true;
  }

  /// 3. Crossings of the grid without an opening.
  size_t fill_gaps() {
    size_t copies = 0;
    for (const GridLine& row : grid_.rows)
      for (const GridLine& column : grid_.columns) {
        const size_t p = pattern_at(patterns_, row, column);
        if (p == patterns_.size()) continue;
        const Vec2 centre = patterns_[p].box.middle();
        const Motion2 motion{centre, Vec2{column.at, row.at} - centre, 0};
        if (!is_free(p, motion, wall_.openings.size())) continue;
        FacadeOpening copy = best_of(p);
        copy.outline = moved(copy.outline, motion);
        copy.piece = piece_around(wall_, outline_points(copy.outline));
        copy.coverage = 0;
        copy.residual_m = kNaN;
        copy.border_points.clear();
        copy.joinery_label = 0;
        wall_.openings.push_back(std::move(copy));
        boxes_.emplace_back();
        is_member_.push_back(true);
        mark(wall_.openings.size() - 1, p);
        ++copies;
      }
    return copies;
  }

  /// Whether a copy may stand there instead of opening i (their number: of none): on the wall, apart from all others,
  /// where no points of the wall lie, and with nothing seen through beside it that the opening would have shown.
  bool is_free(size_t p, const Motion2& motion, size_t i) const {
    const VectorRing ring = moved(best_of(p).outline, motion);
    const RingBox box = ring_box(ring);
    for (size_t k = 0; k < boxes_.size(); ++k)
      if (k != i && box.low.u < boxes_[k].high.u && boxes_[k].low.u < box.high.u &&
          box.low.v < boxes_[k].high.v && boxes_[k].low.v < box.high.v)
        return false;
    const std::vector<Vec2> form = outline_points(ring);
    if (piece_around(wall_, form) == wall_.outlines.size() || shows_wall(wall_, form)) return false;
    return i == wall_.openings.size() || !shows_more(wall_, wall_.openings[i].outline, form);
  }

  FacadeWall& wall_;
  const PatternSetting& setting_;
  std::vector<Pattern> patterns_;
  std::vector<RingBox> boxes_;   ///< of wall_.openings
  std::vector<bool> is_member_;  ///< of a pattern, or a copy
  OpeningGrid grid_;
};

}  // namespace

size_t complete_patterns(FacadeWall& wall, const PatternSetting& setting) {
  if (!setting.enabled || wall.openings.size() < 2) return 0;
  return Completion(wall, setting).run();
}

}  // namespace jalon
