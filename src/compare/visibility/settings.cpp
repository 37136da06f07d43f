// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/settings.h"

#include "base/error.h"
#include "compare/visibility/rows.h"

namespace jalon {

std::span<const ParamRow> visibility_rows() { return kDepthRows; }

void DepthSettings::check() const {
  if (second_centre_m.size() != 3)
    fail(Status::kInvalidArgument, "second_centre_m takes three numbers");
}

void HiddenSettings::check() const {
  if (direction.size() != 3) fail(Status::kInvalidArgument, "hidden_direction takes three numbers");
  if (!(squared_norm(unit_direction()) > 0))
    fail(Status::kInvalidArgument, "hidden_direction has no length");
}

}  // namespace jalon
