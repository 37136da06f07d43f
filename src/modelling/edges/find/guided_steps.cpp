// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/guided_steps.h"

#include <cmath>
#include <optional>

namespace jalon {

namespace {

// Spacings: what a guide may be away, how small a step may be, how short an edge is that may be slanted by noise alone.
constexpr double kReach = 3, kLeastStep = 1.5, kGuidedStepsShort = 12;
constexpr double kAlong = 0.999;  // cosine of lines of one direction
constexpr double kGuidedStepsLeastSine = 0.5;

bool is_upright(const EdgeShape& s) {
  return !s.is_arc && (s.line.direction.u == 0 || s.line.direction.v == 0);
}

bool are_parallel(const EdgeShape& a, const EdgeShape& b) {
  return is_upright(a) && is_upright(b) && (a.line.direction.u == 0) == (b.line.direction.u == 0);
}

// The edge with its ends where the neighbours are; nothing where it would run backwards.
std::optional<EdgeShape> fitted_between(const EdgeShape& a, const EdgeShape& b, EdgeShape edge) {
  const auto from = intersect(a.line, edge.line, kGuidedStepsLeastSine);
  const auto to = intersect(edge.line, b.line, kGuidedStepsLeastSine);
  if (!from || !to || !(dot(edge.line.direction, *to - *from) > 0)) return std::nullopt;
  edge.set_ends(*from, *to);
  return edge;
}

// Across the edges a and b, through p; on a guide where one is near.
EdgeShape step_between(const GuideLines& guides, double spacing_m, const EdgeShape& a,
                       const EdgeShape& b, const Vec2& p) {
  EdgeShape out;
  const Vec2 along = a.line.direction;
  const double side = a.line.distance(b.line.point) > 0 ? 1 : -1;
  out.line = {p, Vec2{-along.v, along.u} * side};
  out.direction = along.u == 0 ? EdgeDirection::kHorizontal : EdgeDirection::kVertical;
  double nearest = INFINITY;
  guides.visit(p, kReach * spacing_m, [&](const EdgeLine& line) {
    const double distance = std::fabs(line.distance(p));
    if (dot(line.direction, out.line.direction) < kAlong || distance >= nearest) return;
    nearest = distance;
    out.line.point = line.foot(p);
    out.is_guided = true;
  });
  return out;
}

// The same on a guide only, with its ends; nothing without a guide near.
std::optional<EdgeShape> guided_step(const GuideLines& guides, double spacing_m, const EdgeShape& a,
                                     const EdgeShape& b, const Vec2& p) {
  const EdgeShape step = step_between(guides, spacing_m, a, b, p);
  return step.is_guided ? fitted_between(a, b, step) : std::nullopt;
}

}  // namespace

void follow_guide(const GuideLines& guides, double spacing_m, const EdgeShape& a,
                  const EdgeShape& b, EdgeShape& edge) {
  if (!are_parallel(a, b) || !is_upright(edge)) return;
  const Vec2 middle = (edge.first + edge.last) * 0.5;
  if (const auto guided = guided_step(guides, spacing_m, a, b, middle)) edge = *guided;
}

void guide_steps(const GuideLines& guides, double spacing_m, std::vector<EdgeShape>& ring) {
  // 1. Slanted ones.
  for (size_t i = 0; i < ring.size() && ring.size() > 3; ++i) {
    const size_t n = ring.size();
    const EdgeShape &a = ring[(i + n - 1) % n], &b = ring[(i + 1) % n];
    EdgeShape& edge = ring[i];
    if (edge.is_arc || is_upright(edge) || edge.length_m > kGuidedStepsShort * spacing_m ||
        !are_parallel(a, b))
      continue;
    const Vec2 middle = (edge.first + edge.last) * 0.5;
    if (const auto guided = guided_step(guides, spacing_m, a, b, middle)) edge = *guided;
  }
  // 2. Missing ones.
  for (size_t i = 0; i < ring.size() && ring.size() > 2; ++i) {
    const EdgeShape &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (!are_parallel(a, b) || dot(a.line.direction, b.line.direction) < kAlong) continue;
    if (std::fabs(a.line.distance(b.line.point)) < kLeastStep * spacing_m) continue;
    const EdgeShape step = step_between(guides, spacing_m, a, b, (a.last + b.first) * 0.5);
    if (const auto fitted = fitted_between(a, b, step))
      ring.insert(ring.begin() + static_cast<ptrdiff_t>(i + 1), *fitted);
  }
}

}  // namespace jalon
