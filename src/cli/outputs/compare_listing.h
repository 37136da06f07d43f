// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/console.h"
#include "cli/lengths.h"
#include "cli/table.h"

namespace jalon::cli {

/// What the command "compare" prints: a line a direction, a table of changes or of regions.
void say_summary(const Console& console, const char* name, const Table& summary,
                 const Lengths& lengths);
/// Of method "landslide": what went, what came, and what was not measured.
void say_landslide(const Console& console, const Table& summary, const Lengths& lengths);
void list_changes(const Console& console, const Table& changes, const Lengths& lengths);
void list_regions(const Console& console, const Table& regions, const Lengths& lengths);

}  // namespace jalon::cli
