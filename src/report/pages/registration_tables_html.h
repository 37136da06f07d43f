// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "registration/registration.h"
#include "report/sheet/html_page.h"

namespace jalon {

/// One sentence: whether it converged, or why it stopped.
std::string outcome_text(const Registration& registration);
/// The pose as four rows, as turn and shift, and with their standard deviations.
void add_pose(Page& page, const Registration& registration);
/// What the search without a start found; nothing where there was none.
void add_search(Page& page, const Registration& registration);
/// The six directions, the weakest first, in words.
void add_directions(Page& page, const Registration& registration);
/// One row a pair with all that its table tells; for pairs few enough to be read.
void add_pairs_table(Page& page, const Registration& registration);

}  // namespace jalon
