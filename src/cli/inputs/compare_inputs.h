// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>

#include "cli/options.h"
#include "cli/table.h"

namespace jalon::cli {

/// Does the file's name say that it holds a model and no points?
bool is_model_file(const std::string& path);

/// The box of all scans, for those that none of their own is told for; "": none. Refused where no input is a scan.
void use_box(const std::string& box, std::initializer_list<Input*> inputs);

/// Points on a model; settings: of operation "model_sample".
Cloud sampled(const Console& console, const Model& model, const Settings& settings);

/// How two scans are compared by default: with detection, and by the scanners' places, known or else found; settings
/// said otherwise win.
void choose_for_scans(const Cloud& reference, const Cloud& compared, bool both,
                      const Settings& settings, const Params& params);

/// The cloud, or of a model points enough to tell where it lies.
Cloud where(const Console& console, const Model& model, const Cloud& cloud);

struct Placed {
  const Input& input;
  Cloud points;
};

/// Ends the command, or warns where it is forced, when two clouds hardly share a place: in one line both boxes, how far
/// they lie apart, and why, as far as it shows.
void refuse_apart(const Console& console, const Placed& reference, const Placed& compared,
                  bool is_forced);

/// What the report says of shadows, from the summaries of what was compared; reverse: NULL one way.
std::string said_of_shadows(const Cloud& reference, const Params& params, const Table& forward,
                            const Table* reverse);

/// Warns where most surfaces differ by more than noise: one line with by how much, and what to do.
void warn_of_misalignment(const Console& console, const Table& summary);

/// The distance beyond which a point has changed; 0 where tests of its own or a field tell what has. summary: of the
/// comparison.
double deciding_threshold(const Table& summary, const Params& change_options);

}  // namespace jalon::cli
