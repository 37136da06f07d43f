// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cli/comparing/direction.h"
#include "cli/lengths.h"
#include "cli/options.h"

namespace jalon::cli {

/// What one side of a comparison was read as: a scan, or a model and points on it.
struct Side {
  const Model& model;
  const Cloud& cloud;
};

/// What "compare" makes besides distances and changes when it is asked to: volumes, the set of closest points, depth
/// maps of the stations, a third epoch.
class Extras {
 public:
  void add_to(Command& command);
  static std::string tables();
  bool is_given() const {
    return with_volumes_ || with_closest_ || with_depth_maps_ || !third_.path.empty();
  }

  /// Refuses what these sides have no answer to, before a long read.
  void check(bool reference_is_model, bool compared_is_model, const std::string& method) const;
  /// "--third": what was hidden from the reference, by the epoch beyond it. worker: the comparer of both. Gives back
  /// what the result tells of it; null where there is none.
  nlohmann::ordered_json use_third_epoch(Console& console, const jalon_comparer* worker,
                                         const Cloud& compared, Direction& forward) const;
  /// Writes the others and adds what they tell to the result.
  void write(const Console& console, const PathOf& path_of, const Side& reference,
             const Side& compared, const Direction& forward, nlohmann::ordered_json& result) const;
  /// A line each.
  void say(const Console& console, const nlohmann::ordered_json& result,
           const Lengths& lengths) const;

  Input& third() { return third_; }

 private:
  bool with_volumes_ = false, with_closest_ = false, with_depth_maps_ = false;
  Settings volume_settings_, depth_settings_;
  Input third_;
  double third_tolerance_m_ = 0.1;  // the depth maps' own margin, depth_margin_m
};

}  // namespace jalon::cli
