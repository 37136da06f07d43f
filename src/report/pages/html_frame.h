// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "report/names/notes.h"
#include "report/sheet/html_page.h"

namespace jalon {

/// Head and style of every report; the body is left open.
void open_page(Page& page, std::string_view title);
/// Seconds by stage.
void add_times(Page& page, const Notes& notes);
/// A JSON object as a table of names and values; nothing for "".
void add_parameters(Page& page, std::string_view json);

}  // namespace jalon
