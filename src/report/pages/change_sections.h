// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "report/pages/change_places.h"
#include "report/pictures/deviation_colours.h"
#include "report/sheet/html_page.h"

namespace jalon {

/// The table of changes (of a diagnosis) or regions, as wide as a page is.
void add_change_table(Page& page, const FieldTable& changes);
/// A page for each place: what is known of the change, and its surroundings in both epochs side by side.
void add_change_pages(Page& page, const Comparison& forward, const Comparison* reverse,
                      const FieldTable& changes, std::span<const ChangePlace> places,
                      const DeviationScale& scale, Task& task);

}  // namespace jalon
