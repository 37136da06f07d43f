// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/visibility/visibility.h"
#include "earthworks.h"

// What is asked for: at least 95 % of true shadow points labelled, at most 2 % of commonly seen
// points lost. Truth is an exact ray from the other day's scanner through that day's scene.

namespace jalon::earthworks_visibility_test {

using namespace jalon::test;

namespace {

/// Five times the noise of a range: what lies nearer to the surface was seen by both. (The spot of a beam averages: its
/// points are not quite on the surface.)
constexpr double kOnSurface_m = 0.03;

struct Score {
  size_t shadow = 0, shadow_found = 0;  ///< behind the surface, by more than the margin
  size_t near = 0,
         near_found = 0;  ///< behind it, within the margin: counts as seen by its definition
  size_t common = 0, common_lost = 0;
  Score& operator+=(const Score& b) {
    shadow += b.shadow, shadow_found += b.shadow_found, near += b.near, near_found += b.near_found;
    common += b.common, common_lost += b.common_lost;
    return *this;
  }
};

Score score(const SiteDay& reference, const SiteDay& compared) {
  const DepthSettings settings;
  Task task;
  const auto labels =
      visibility_labels(VisibilityTest(*reference.cloud, settings, task), *compared.cloud, task);
  Score out;
  for (size_t i = 0; i < labels.size(); ++i) {
    const Vec3 p = true_point(*compared.cloud, i);
    if (!reference.is_in_field(p)) continue;
    const double behind = reference.depth_behind(p), range = norm(p - reference.pose.translation());
    const bool is_hidden = labels[i] == static_cast<uint8_t>(Visibility::kHidden);
    if (behind > settings.margin_m + (settings.margin_factor - 1) * range) {
      ++out.shadow;
      out.shadow_found += is_hidden;
    } else if (behind > kOnSurface_m) {
      ++out.near;
      out.near_found += is_hidden;
    } else if (behind > -kOnSurface_m) {
      ++out.common;
      out.common_lost += labels[i] != static_cast<uint8_t>(Visibility::kVisible);
    }
  }
  return out;
}

double percent(size_t part, size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

TEST_CASE("earthworks__shadows_are_labelled_and_common_ground_is_kept_on_all_pairs_of_days") {
  Score all;
  for (size_t r = 0; r < 4; ++r)
    for (size_t c = 0; c < 4; ++c) {
      if (r == c) continue;
      const Score s = score(site_days()[r], site_days()[c]);
      all += s;
      MESSAGE("FIGURE day " << c + 1 << " against day " << r + 1 << ": hidden "
                            << percent(s.shadow_found, s.shadow) << " % of " << s.shadow
                            << " shadow points, lost " << percent(s.common_lost, s.common)
                            << " % of " << s.common << " seen by both");
      CHECK(percent(s.shadow_found, s.shadow) >= 95);
      CHECK(percent(s.common_lost, s.common) <= 2);
    }
  MESSAGE("FIGURE all pairs: hidden "
          << percent(all.shadow_found, all.shadow) << " % of " << all.shadow << ", lost "
          << percent(all.common_lost, all.common) << " %; with those within the margin "
          << percent(all.shadow_found + all.near_found, all.shadow + all.near) << " % of "
          << all.shadow + all.near);
  CHECK(percent(all.shadow_found + all.near_found, all.shadow + all.near) >= 95);
}

}  // namespace jalon::earthworks_visibility_test
