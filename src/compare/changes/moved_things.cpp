// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/moved_things.h"

#include <algorithm>

#include "compare/changes/change_confidence.h"

namespace jalon {

namespace {

// What moved whole has points in both epochs, if not as many, and much of it changed: what does not costs no search.
constexpr double kLikeCount = 0.2, kChangedOfWhole = 0.1;
constexpr size_t kPartners = 4;  // of a group: the nearest ones that it is paired with

struct Motion {
  std::vector<size_t> seeds;  ///< groups that it was looked for from
  Change change;
};

void add_all(std::vector<uint32_t>& to, const std::vector<uint32_t>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

class Weighing {
 public:
  Weighing(const ObjectMotionJob& job, double reach, std::vector<ChangeGroup>& groups)
      : job_(job), reach_(reach), groups_(groups) {}

  std::vector<Motion> motions() {
    for (size_t k = 0; k < groups_.size(); ++k) {
      job_.task.checkpoint(static_cast<double>(k) / static_cast<double>(groups_.size()));
      if (groups_[k].points() >= kLeastToldPoints) weigh({k}, groups_[k].object);
    }
    for (size_t k = 0; k < groups_.size(); ++k)
      for (const size_t other : partners_of(k))
        weigh({k, other}, joined(groups_[k].object, groups_[other].object));
    return std::move(motions_);
  }

 private:
  // Of what went: the nearest of what came.
  std::vector<size_t> partners_of(size_t k) const {
    std::vector<std::pair<double, size_t>> near;
    const ChangeGroup& gone = groups_[k];
    if (!gone.only_before()) return {};
    for (size_t c = 0; c < groups_.size(); ++c) {
      const ChangeGroup& come = groups_[c];
      if (!come.only_after() || gone.points() + come.points() < kLeastToldPoints) continue;
      const double size =
          std::max(norm(gone.box.max - gone.box.min), norm(come.box.max - come.box.min));
      const double way = norm(gone.box.max + gone.box.min - come.box.max - come.box.min) / 2;
      if (way <= reach_ * size) near.emplace_back(way, c);
    }
    std::sort(near.begin(), near.end());
    std::vector<size_t> out;
    for (size_t i = 0; i < std::min(near.size(), kPartners); ++i) out.push_back(near[i].second);
    return out;
  }

  bool is_weighed_together(const std::vector<size_t>& seeds) const {
    return std::any_of(motions_.begin(), motions_.end(), [&](const Motion& motion) {
      return std::all_of(seeds.begin(), seeds.end(), [&](size_t k) {
        return lies_in(groups_[k].object, motion.change.object);
      });
    });
  }

  void weigh(const std::vector<size_t>& seeds, const ChangedObject& changed) {
    if (is_weighed_together(seeds)) return;
    ChangedObject whole = whole_object(job_.before, job_.after, changed.before, changed.after,
                                       job_.tolerance_m, job_.task);
    const auto was = static_cast<double>(whole.before.size()),
               is = static_cast<double>(whole.after.size());
    const auto part = static_cast<double>(changed.before.size() + changed.after.size());
    if (std::min(was, is) < kLikeCount * std::max(was, is) || part < kChangedOfWhole * (was + is))
      return;
    Motion motion{seeds, {}};
    if (!motion_of_whole(job_, std::move(whole), motion.change)) return;
    for (const size_t k : seeds) {
      add_all(motion.change.object.regions_before, groups_[k].object.regions_before);
      add_all(motion.change.object.regions_after, groups_[k].object.regions_after);
    }
    set_own_features(job_, motion.change);
    motion.change.confidence = confidence_of(motion.change);
    motions_.push_back(std::move(motion));
  }

  const ObjectMotionJob& job_;
  double reach_;
  std::vector<ChangeGroup>& groups_;
  std::vector<Motion> motions_;
};

}  // namespace

MovedThings take_moved_things(const ObjectMotionJob& job, double reach,
                              std::vector<ChangeGroup>& groups) {
  std::stable_sort(groups.begin(), groups.end(), [](const ChangeGroup& a, const ChangeGroup& b) {
    return a.points() > b.points();
  });
  std::vector<Motion> motions = Weighing(job, reach, groups).motions();
  std::stable_sort(motions.begin(), motions.end(), [](const Motion& a, const Motion& b) {
    return a.change.confidence > b.change.confidence;
  });
  std::vector<uint8_t> is_taken(groups.size(), 0);
  MovedThings out;
  for (Motion& motion : motions) {
    Change& change = motion.change;
    const bool is_free = std::none_of(motion.seeds.begin(), motion.seeds.end(),
                                      [&](size_t k) { return is_taken[k] != 0; });
    if (!is_free || !is_told(change)) {
      out.others.push_back(std::move(change));
      continue;
    }
    for (const size_t k : motion.seeds) is_taken[k] = 1;
    for (size_t k = 0; k < groups.size(); ++k) {
      if (is_taken[k] != 0 || !lies_in(groups[k].object, change.object)) continue;
      is_taken[k] = 1;
      add_all(change.object.regions_before, groups[k].object.regions_before);
      add_all(change.object.regions_after, groups[k].object.regions_after);
    }
    out.moved.push_back(std::move(change));
  }
  size_t kept = 0;
  for (size_t k = 0; k < groups.size(); ++k)
    if (is_taken[k] == 0) {
      if (kept != k) groups[kept] = std::move(groups[k]);
      ++kept;
    }
  groups.resize(kept);
  return out;
}

}  // namespace jalon
