// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "modelling/evaluation/area_indices.h"

namespace jalon {

constexpr auto kIndexRows = setting_rows(choice_row<&IndexSettings::formulas>(
    "formulas", "canonical|thesis", "",
    "canonical: branching FP/TP, miss FN/TP; thesis: as printed in Boulaassal 2010, table 5.5: "
    "swapped"));

}  // namespace jalon
