// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/field.h"
#include "registration/network/network_adjustment.h"

namespace jalon {

/// As jalon/network.h has them.
FieldTable network_summary(const NetworkAdjustment& network);
FieldTable network_points(const NetworkAdjustment& network);
FieldTable network_observations(const NetworkAdjustment& network);
/// Lines "ID;X;Y;Z;code" of the points with a code, to the tenth of a millimetre.
std::string network_codes(const NetworkAdjustment& network);

}  // namespace jalon
