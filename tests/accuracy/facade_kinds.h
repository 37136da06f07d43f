// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Kinds of facades that no seed draws. The first ones were reported once, and are developed with since.
#pragma once

#include <cstdint>
#include <iterator>

#include "scan/grammar_settings.h"

namespace jalon::test {

constexpr FacadeKind kNamedKinds[] = {FacadeKind::kTimbered, FacadeKind::kVilla,
                                      FacadeKind::kSchool, FacadeKind::kSheds, FacadeKind::kNave};
constexpr FacadeKind kTownKinds[] = {FacadeKind::kWarehouse, FacadeKind::kStaggered,
                                     FacadeKind::kCorner};

using KindOfSeed = FacadeKind (*)(uint64_t);
inline FacadeKind drawn_kind(uint64_t) { return FacadeKind::kAny; }
/// One after the other.
inline FacadeKind named_kind(uint64_t seed) { return kNamedKinds[seed % std::size(kNamedKinds)]; }
inline FacadeKind town_kind(uint64_t seed) { return kTownKinds[seed % std::size(kTownKinds)]; }

}  // namespace jalon::test
