// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "report/elevation/opening_list.h"
#include "report/names/notes.h"
#include "report/sheet/html_page.h"
#include "segment/segmentation.h"

namespace jalon {

// Chapters of the report that a model adds; each writes nothing when there is nothing to tell.

/// Types of the openings, then each opening with the standard deviations of its measures.
void add_openings(Page& page, const Model& model, const OpeningList& openings);
/// How well each plane is determined, by its adjustment and, where it is told, by the scanner.
void add_precision(Page& page, const Segmentation& segmentation, const Notes& notes, Task& task);
/// The tree of parts and how each is known.
void add_parts(Page& page, const Model& model);

/// A table of two columns: names and values.
void add_pairs(Page& page, const std::vector<std::pair<std::string, std::string>>& pairs);

}  // namespace jalon
