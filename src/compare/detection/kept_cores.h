// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "compare/detection/surface_cores.h"

namespace jalon {

/// The surfaces of two clouds that are compared.
struct CorePair {
  std::shared_ptr<const SurfaceCores> reference, compared;
};

/// Those of a comparison the other way round that was kept and not taken yet, about this origin; else none.
CorePair take_kept_cores(const Cloud& reference, const Cloud& compared, const Vec3& origin,
                         Task& task);
/// Keeps them for one comparison the other way round, as long as what comes back lives: it makes nothing anew, and
/// nothing stays when it is done.
std::shared_ptr<const void> keep_cores(const Cloud& reference, CorePair cores);

}  // namespace jalon
