// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/params.h"
#include "capi/handles.h"
#include "compare/comparison.h"

struct jalon_comparer : jalon::capi::Counted {
  std::string method;
  std::shared_ptr<jalon::ParamSet> values;  ///< shared with the jalon_params handles of this comparer
};

struct jalon_comparison : jalon::capi::Counted {
  jalon::ComparisonPtr comparison;
};
