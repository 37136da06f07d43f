// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/coarse/search.h"
#include "registration/registration.h"

namespace jalon {

/// The columns of method "coarse" (jalon/registrar.h). found: poses between the clouds themselves.
void fill_coarse_tables(Registration& registration, const CoarseSearch& found, double cell_m, size_t candidates);

}  // namespace jalon
