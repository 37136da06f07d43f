// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/fronts.h"

#include <cmath>

#include "segment/front/free_space.h"
#include "segment/front/near_wall.h"
#include "segment/front/shared_viewers.h"
#include "segment/front/side.h"

namespace jalon {

double WallFront::confidence() const { return probability_of(std::fabs(log_odds)); }

std::vector<WallFront> wall_fronts(const Cloud& cloud, const Vec3& origin,
                                   std::span<const uint32_t> labels,
                                   const std::vector<Segment>& segments, Task& task) {
  std::vector<WallFront> out;
  std::vector<WallGroup> groups = wall_groups(segments);
  if (groups.empty()) return out;
  const SparsePlaces places = sparse_places(cloud, origin, task);
  std::vector<WallSheet> sheets;
  std::vector<double> log_odds;
  for (WallGroup& group : groups) {
    const WallSheet& sheet = sheets.emplace_back(cloud, origin, labels, segments, group, task);
    FrontEvidence evidence;
    look_near(cloud, origin, labels, segments, group, sheet, evidence, task);
    look_through(places, sheet, evidence, task);
    log_odds.push_back(front_log_odds(evidence));
    WallFront& front = out.emplace_back();
    front.evidence = evidence;
    front.group = std::move(group);
  }
  share_viewers(sheets, log_odds);
  for (size_t g = 0; g < out.size(); ++g) {
    out[g].log_odds = log_odds[g];
    out[g].viewer = viewer_before(sheets[g], out[g].is_before() ? 1 : -1);
  }
  return out;
}

}  // namespace jalon
