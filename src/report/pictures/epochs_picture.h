// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/task.h"
#include "compare/comparison.h"
#include "report/pictures/deviation_colours.h"

namespace jalon {

struct EpochPanel {
  std::string caption;
  const Comparison* comparison = nullptr;
};

/// One place in several epochs side by side, on one scale, as an SVG figure: their points around what changed, in the
/// colours of their distances, with its outline. An upright plane that changed is seen from before it, all else from
/// above or from the side. changed: at least one point; around_m: what is shown about it.
std::string epochs_svg(std::span<const EpochPanel> panels, std::span<const Vec3> changed,
                       double around_m, const DeviationScale& scale, Task& task);

}  // namespace jalon
