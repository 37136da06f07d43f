// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "base/task.h"
#include "report/sheet/html_page.h"
#include "report/viewer/scene.h"

namespace jalon {

/// The policy of a page: it loads nothing, and runs the viewer's script alone.
std::string content_policy();
/// What the style of a page adds for the view; it is not printed.
const char* viewer_style();

/// The section "In three dimensions"; nothing for 0 points or a scene without points. A page has one.
void add_viewer(Page& page, const ViewScene& scene, int64_t most_points, Task& task);

}  // namespace jalon
