// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/adjusted_attributes.h"

#include "model/buildings/part_numbers.h"
#include "model/part_classes.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

namespace {

class Attributes {
 public:
  Attributes(const JointAdjustment& adjustment, const JointSettings& settings, const Model& strips)
      : a_(adjustment), s_(settings), model_(strips), numbers_(part_numbers(strips)) {
    made_.of_part.resize(strips.parts.size());
    count_matches();
  }

  PartAttributes run() {
    for (uint32_t p = 0; p < model_.parts.size(); ++p) {
      const std::string& part_class = model_.parts[p].part_class;
      const PartNumbers& n = numbers_[p];
      if (n.block == kNoStrip) continue;  // the ground
      made_.add_whole(p, "block", n.block);
      if (part_class == part_class::kBlock || part_class == part_class::kBuilding)
        add_block(p, n.block);
      if (n.facade != kNoStrip) add_facade(p, n.facade);
      if (n.strip != kNoStrip) add_strip(p, n);
    }
    return std::move(made_);
  }

 private:
  void count_matches() {
    block_matches_.assign(a_.model.blocks.size(), 0);
    facade_matches_.assign(a_.model.facades.size(), 0);
    for (uint32_t p = 0; p < model_.parts.size(); ++p) {
      const PartNumbers& n = numbers_[p];
      if (model_.parts[p].part_class != part_class::kStrip || n.block == kNoStrip ||
          n.facade == kNoStrip)
        continue;
      block_matches_[n.block] += a_.strip_points[n.strip];
      facade_matches_[n.facade] += a_.strip_points[n.strip];
    }
  }

  void add_block(uint32_t p, uint32_t block) {
    made_.add(p, "block_offset_east_m", a_.model.blocks[block].u);
    made_.add(p, "block_offset_north_m", a_.model.blocks[block].v);
    made_.add(p, "block_prior_sigma_east_m", s_.sigma_block_x_m);
    made_.add(p, "block_prior_sigma_north_m", s_.sigma_block_y_m);
    made_.add(p, "block_sigma_east_m", a_.block_sigmas[block].u);
    made_.add(p, "block_sigma_north_m", a_.block_sigmas[block].v);
    made_.add_whole(p, "block_matches", block_matches_[block]);
  }

  void add_facade(uint32_t p, uint32_t facade) {
    made_.add_whole(p, "facade", facade);
    made_.add(p, "facade_offset_m", a_.model.facades[facade]);
    made_.add(p, "facade_prior_sigma_m", s_.sigma_facade_m);
    made_.add(p, "facade_sigma_m", a_.facade_sigmas[facade]);
    made_.add_whole(p, "facade_matches", facade_matches_[facade]);
  }

  void add_strip(uint32_t p, const PartNumbers& n) {
    made_.add_whole(p, "strip", n.strip);
    made_.add(p, "strip_offset_m", a_.model.strips[n.strip]);
    made_.add(p, "strip_prior_sigma_m", s_.sigma_strip_m);
    made_.add(p, "strip_sigma_m", a_.strip_sigmas[n.strip]);
    made_.add_whole(p, "strip_matches", a_.strip_points[n.strip]);
    made_.add(p, "strip_distance_before_m", a_.strip_distances_m[n.strip]);
  }

  const JointAdjustment& a_;
  const JointSettings& s_;
  const Model& model_;
  std::vector<PartNumbers> numbers_;
  std::vector<uint64_t> block_matches_, facade_matches_;
  PartAttributes made_;
};

}  // namespace

PartAttributes adjusted_attributes(const JointAdjustment& adjustment, const JointSettings& settings,
                                   const Model& strips) {
  return Attributes(adjustment, settings, strips).run();
}

}  // namespace jalon
