// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/sweep_contact.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace jalon {

namespace {

constexpr size_t kCorners = 3;
/// A cut leaves at least this share of the span on either side, so that spans shrink.
constexpr double kLeastShare = 0.05;
/// Looks at a ball before it counts as near: a bound that is not clear by then is not worth more than opening the ball.
constexpr int kBallLooks = 8;

/// The obstacle and its contact at one time.
struct Look {
  double time = 0;
  std::array<Vec3, kCorners> corners;
  Contact contact;
};

struct SpanOfTime {
  Look from, to;
};

/// One line of a bound: its height at both ends of the span.
struct Line {
  double from, to;
};

Look look_at(const ConvexPiece& piece, const Motion& motion, std::span<const Vec3> starts,
             double time) {
  Look look;
  look.time = time;
  for (size_t i = 0; i < starts.size(); ++i) look.corners[i] = motion.seen_at(starts[i], time);
  look.contact = least_distance(piece, {look.corners.data(), starts.size()});
  return look;
}

/// How far the corners may leave their chords during a span, in any direction that is across the axis.
struct Sag {
  const Motion& motion;
  double acceleration_m;

  double along(const Vec3& slope, const SpanOfTime& span) const {
    const double h = span.to.time - span.from.time;
    return acceleration_m == 0 ? 0 : acceleration_m * motion.across_axis(slope) * h * h / 8;
  }
};

// Heights of the corners' paths, at least, above the plane below the signed distance that a contact has.
std::array<Line, kCorners> lines_of(const Contact& c, const SpanOfTime& span, size_t count,
                                    const Sag& sag) {
  std::array<Line, kCorners> lines;
  const double floor = c.floor - sag.along(c.slope, span);
  for (size_t i = 0; i < count; ++i)
    lines[i] = {floor + dot(c.slope, span.from.corners[i] - c.point),
                floor + dot(c.slope, span.to.corners[i] - c.point)};
  return lines;
}

double lowest_at(const std::array<Line, kCorners>& lines, size_t count, double share) {
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < count; ++i)
    lowest = std::min(lowest, lines[i].from + share * (lines[i].to - lines[i].from));
  return lowest;
}

/// Lower bound of the distance over a span, and the share of the span where it is least. Each end gives
/// the lowest of its lines, a concave function; the greater of two concave functions is least at an end or where they
/// cross.
double least_bound(const SpanOfTime& span, size_t count, const Sag& sag, double& share) {
  const auto a = lines_of(span.from.contact, span, count, sag),
             b = lines_of(span.to.contact, span, count, sag);
  double bound = std::numeric_limits<double>::infinity();
  const auto consider = [&](double s) {
    const double height = std::max(lowest_at(a, count, s), lowest_at(b, count, s));
    if (height < bound) {
      bound = height;
      share = s;
    }
  };
  consider(0);
  consider(1);
  for (size_t i = 0; i < count; ++i)
    for (size_t j = 0; j < count; ++j) {
      const double from = a[i].from - b[j].from, to = a[i].to - b[j].to;
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) consider(from / (from - to));
    }
  return bound;
}

/// Bound of a span, and the time where to cut it.
double bound_of(const SpanOfTime& span, size_t count, const Sag& sag, double& cut) {
  const double bound = least_bound(span, count, sag, cut);
  cut = span.from.time +
        (span.to.time - span.from.time) * std::clamp(cut, kLeastShare, 1 - kLeastShare);
  return bound;
}

double acceleration_of(const Motion& motion, std::span<const Vec3> corners) {
  double most = 0;
  for (const Vec3& c : corners) most = std::max(most, motion.acceleration_m(c));
  return most;
}

}  // namespace

bool least_during(const ConvexPiece& piece, const Motion& motion, std::span<const Vec3> corners,
                  double limit, SweptContact& out) {
  const Sag sag{motion, acceleration_of(motion, corners)};
  double best = limit;
  bool found = false;
  const auto take = [&](const Look& look) {
    if (look.contact.value > best || (found && look.contact.value == best)) return;
    best = look.contact.value;
    out = {look.contact, look.time};
    found = true;
  };
  std::vector<SpanOfTime> open{
      {look_at(piece, motion, corners, 0), look_at(piece, motion, corners, 1)}};
  take(open.back().from);
  take(open.back().to);
  while (!open.empty()) {
    const SpanOfTime span = open.back();
    open.pop_back();
    double cut = 0;
    const double gap = std::max(span.from.contact.gap, span.to.contact.gap);
    if (bound_of(span, corners.size(), sag, cut) >= best - gap - kSweepTolerance_m) continue;
    const Look middle = look_at(piece, motion, corners, cut);
    take(middle);
    open.push_back({middle, span.to});
    open.push_back({span.from, middle});
  }
  return found;
}

bool may_come_within(const ConvexPiece& piece, const Motion& motion, const Vec3& centre,
                     double radius_m, double limit, double& lowest) {
  const std::span<const Vec3> one(&centre, 1);
  const Sag sag{motion, motion.acceleration_m(centre)};
  const double near = limit + radius_m;
  std::array<SpanOfTime, kBallLooks + 1> open;
  size_t count = 1;
  open[0] = {look_at(piece, motion, one, 0), look_at(piece, motion, one, 1)};
  lowest = std::min(open[0].from.contact.value, open[0].to.contact.value) - radius_m;
  int looks = 0;
  while (count > 0) {
    if (lowest <= limit) return true;
    const SpanOfTime span = open[--count];
    double cut = 0;
    if (bound_of(span, 1, sag, cut) > near) continue;
    if (looks++ == kBallLooks) return true;
    const Look middle = look_at(piece, motion, one, cut);
    lowest = std::min(lowest, middle.contact.value - radius_m);
    open[count++] = {middle, span.to};
    open[count++] = {span.from, middle};
  }
  return false;
}

}  // namespace jalon
