// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/params.h"

namespace jalon {

/// settings: the struct of that tag, to which all rows are bound.
std::string settings_json(std::span<const ParamRow> rows, const void* settings, const char* tag);

/// A settings struct as ParamSet::to_json() gives its values: what a result was made with.
template <class S>
std::string settings_json(std::span<const ParamRow> rows, const S& settings) {
  return settings_json(rows, &settings, &kSettingsTag<S>);
}

}  // namespace jalon
