// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

// The words of Part::part_class that all rooms know (windows, doors and their parts); others may occur and mean nothing
// to them.
namespace jalon::part_class {

inline constexpr char kBlock[] = "block";  ///< buildings that touch one another
inline constexpr char kBuilding[] = "building";
inline constexpr char kFacade[] = "facade";
inline constexpr char kStrip[] = "strip";  ///< of a facade, from the ground to the top
inline constexpr char kWall[] = "wall";
inline constexpr char kWindow[] = "window";
inline constexpr char kDoor[] = "door";
inline constexpr char kGateway[] = "gateway";  ///< wide enough for a cart, open or with gates
inline constexpr char kShopFront[] = "shop_front";
inline constexpr char kVent[] = "vent";
inline constexpr char kRecess[] = "recess";    ///< a wall stands back in it: a loggia, an arcade
inline constexpr char kOpening[] = "opening";  ///< none of these for certain, or something else
/// All of these, in the order of lists and legends.
inline constexpr const char* kOpenings[] = {kWindow, kDoor,   kGateway, kShopFront,
                                            kVent,   kRecess, kOpening};
inline bool is_opening(std::string_view word) {
  return std::find(std::begin(kOpenings), std::end(kOpenings), word) != std::end(kOpenings);
}
inline constexpr char kReveal[] = "reveal";    ///< the sides of an opening between wall and joinery
inline constexpr char kJoinery[] = "joinery";  ///< frames, panes, leaves behind an opening
inline constexpr char kSill[] = "sill";
inline constexpr char kCornice[] = "cornice";
inline constexpr char kStringCourse[] = "string_course";
inline constexpr char kBaseCourse[] = "base_course";
inline constexpr char kPost[] = "post";
inline constexpr char kGround[] = "ground";
inline constexpr char kRoof[] = "roof";
inline constexpr char kElement[] = "element";  ///< any other plane
inline constexpr char kGutter[] = "gutter";    ///< a downpipe of its building
/// Nothing was measured there, whether the wall is drawn by its contour or by its evidence: its face fills a hole or a
/// notch of the wall's. Without a face: the wall is filled there, because the user asked for it.
inline constexpr char kNoData[] = "no_data";

// Of the outlines of change regions; "_before" or "_after" behind those of what is there in both epochs.
inline constexpr char kChanges[] = "changes";  ///< all of them
inline constexpr char kRegion[] = "region";    ///< of no class
inline constexpr char kAppearance[] = "appearance";
inline constexpr char kDisappearance[] = "disappearance";
inline constexpr char kDisplacement[] = "displacement";
inline constexpr char kDeformation[] = "deformation";
// Of the outlines of a landslide.
inline constexpr char kDepletion[] = "depletion";
inline constexpr char kAccumulation[] = "accumulation";
inline constexpr char kUnmeasured[] = "unmeasured";  ///< by one epoch or both

}  // namespace jalon::part_class
