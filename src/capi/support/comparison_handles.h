// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "base/error.h"
#include "base/params.h"
#include "base/shared_text.h"
#include "capi/support/handles.h"
#include "compare/comparison.h"
#include "compare/methods.h"

struct jalon_comparer : jalon::capi::Counted {
  const jalon::CompareMethod* method = nullptr;
  std::shared_ptr<jalon::ParamSet>
      values;  ///< shared with the jalon_params handles of this comparer
};

struct jalon_comparison : jalon::capi::Counted {
  jalon::ComparisonPtr comparison;
};

namespace jalon::capi {

/// Where both are known.
inline void require_same_crs(const SharedText& reference, const SharedText& compared) {
  if (!reference.empty() && !compared.empty() && reference != compared)
    fail(Status::kInvalidArgument,
         "the CRS of the reference (%.60s) and of the compared data (%.60s) differ",
         reference.c_str(), compared.c_str());
}

}  // namespace jalon::capi
