// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "formats/registry.h"

namespace jalon {

/// The format of the option, of the content, of the extension, in this order; Error where there is none.
const Format& format_to_read(const ByteSource& source, const ReadSettings& settings);
/// The format of the option or the extension; null where no format has it.
const Format* format_to_write(const std::string& path, const WriteSettings& settings);

}  // namespace jalon
