// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"

namespace jalon {

/// Kinds of facades of the scene "grammar".
enum class FacadeKind {
  kAny,
  kTownHouse,
  kApartments,
  kShops,
  kArcade,
  kOffices,
  kGabled,
  kWings,
  kLoggias,
  kChurch,
  kFactory,
  kTerrace,
  kMansard,
  kTimbered,
  kVilla,
  kSchool,
  kSheds,
  kNave,
  kWarehouse,
  kStaggered,
  kCorner,
  kMill,
  kInn,
  kParade
};
constexpr int kFacadeKinds = 23;
/// kAny draws among these first ones: a seed keeps its facade when a kind is added.
constexpr int kDrawnKinds = 12;
/// As the parameter "kind" has it.
const char* name_of(FacadeKind kind);

/// What the seed decides unless it is told.
enum class BySeed { kSeed, kYes, kNo };

/// Of the scene "grammar"; the table of the rows says what each member means.
struct GrammarSettings {
  FacadeKind kind = FacadeKind::kAny;
  double front_m = 0;
  int64_t floors = 0;
  double spacing_m = 0, noise_m = -1, misfit_m = -1;
  int64_t stations = 0;
  BySeed occluders = BySeed::kSeed, glass = BySeed::kSeed, gaps = BySeed::kSeed;
};

inline constexpr auto kGrammarRows = setting_rows(
    choice_row<&GrammarSettings::kind>(
        "kind",
        "any|town_house|apartments|shops|arcade|offices|gabled|wings|loggias|church|factory|"
        "terrace|mansard|timbered|villa|school|sheds|nave|warehouse|staggered|corner|mill|inn|"
        "parade",
        "grammar",
        "kind of facade: any: one of the next twelve by the seed; town_house: surrounds, shutters, "
        "balconies; apartments: balconies and blinds; shops: shop fronts, signs, canopies; arcade: "
        "arches on the ground; offices: mullions and panels; gabled: a gable with sloping and "
        "triangular windows; wings: set-backs and a pediment; loggias: recesses and a gateway; "
        "church: pointed and round windows; factory: bands of windows, large gates; terrace: "
        "narrow houses some centimetres apart; mansard: arched windows, a long balcony, dormers; "
        "timbered: storeys that stand out, timbers, uneven bays; villa: a gabled part, a bay "
        "window, shutters; school: ribbons of windows, sun screens, a stair; sheds: a saw-tooth "
        "roof, high strips of windows; nave: lancets between buttresses; warehouse: segmental "
        "arches, "
        "loading doors above each other; staggered: windows of three sizes on no grid, balconies "
        "in "
        "recesses; corner: shops, an oriel, a cut corner; mill: broad arched windows between "
        "lesenes; "
        "inn: "
        "shutters open beside every window; parade: glazed shops under awnings, thin fins above"),
    number_row<&GrammarSettings::front_m>("front_m", 0, 60, "m", "grammar",
                                          "length of the front; 0: by the seed"),
    integer_row<&GrammarSettings::floors>("floors", 0, 12, "1", "grammar",
                                          "storeys, as far as the kind has them; 0: by the seed"),
    number_row<&GrammarSettings::spacing_m>(
        "spacing_m", 0, 0.5, "m", "grammar",
        "spacing of a station's points where it looks straight at the front; 0: 3 to 40 mm by the "
        "seed, as far as 2.5 million points allow"),
    number_row<&GrammarSettings::noise_m>("noise_m", -1, 0.1, "m", "grammar",
                                          "standard deviation of the measured distance; negative: "
                                          "2 to 8 mm by the seed"),
    number_row<&GrammarSettings::misfit_m>(
        "misfit_m", -1, 0.1, "m", "grammar",
        "standard deviation of each coordinate of a recorded station; negative: up to 3 mm by the "
        "seed"),
    integer_row<&GrammarSettings::stations>("stations", 0, 4, "1", "grammar",
                                            "scanner positions; 0: 1 to 4 by the seed"),
    choice_row<&GrammarSettings::occluders>("occluders", "seed|yes|no", "grammar",
                                            "trees, cars, people and posts before the front"),
    choice_row<&GrammarSettings::glass>(
        "glass", "seed|yes|no", "grammar",
        "yes: glass returns a share of the pulses and shows curtains and rooms behind; no: it "
        "returns all of them"),
    choice_row<&GrammarSettings::gaps>(
        "gaps", "seed|yes|no", "grammar",
        "bands that return nothing: dark signs and canopies, and panes that mirror"));

}  // namespace jalon
