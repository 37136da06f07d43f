// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/options.h"

namespace jalon::cli {

/// Does the file's name say that it holds a model and no points?
bool is_model_file(const std::string& path);

/// Points on a model; settings: of operation "model_sample".
Cloud sampled(const Console& console, const Model& model, const Settings& settings);

/// Where all points of the reference, and both ways of the compared scan too, have a scanner's place, sets what leaves
/// out its shadows; settings said otherwise win. Returns what the report says of shadows.
std::string use_stations(const Cloud& reference, const Cloud& compared, bool both,
                         const Settings& settings, const Params& params);

}  // namespace jalon::cli
