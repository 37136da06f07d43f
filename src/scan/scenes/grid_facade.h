// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/random.h"
#include "scan/builder/builder.h"

namespace jalon {

/// A school block of the 1950s: a closed wall, then bays between posts; in each bay and storey a breast wall, windows
/// between mullions, a band at the slab; a cornice. Depths are y: the facade looks along -Y, so smaller is further
/// out. Storey k reaches from k to k + 1 times its height, its band the last of it.
struct GridFacade {
  double wall_width_m, bay_width_m;
  int bays, storeys;
  double storey_height_m, band_height_m, post_width_m;
  double front_y, wall_y, breast_y, glass_y, mullion_y;
  double breast_height_m, window_height_m, mullion_width_m;
  int mullions;  ///< of a bay
  double cornice_z, cornice_height_m, cornice_y;
  double curtain_share, open_share;  ///< of the windows
  double curtain_nearest_y, curtain_farthest_y;
  double balcony_depth_m;  ///< before the front, in every second bay of the upper storeys; 0: none

  double width() const { return wall_width_m + bays * bay_width_m; }
  double clear_height() const { return storey_height_m - band_height_m; }
  /// Start of bay i's post; the last one ends with the facade.
  double post_x(int i) const {
    return i < bays ? wall_width_m + i * bay_width_m : width() - post_width_m;
  }
};

/// Builds it and gives the part of the house; the stream says which windows are open and which have curtains.
uint32_t build_grid_facade(const GridFacade& facade, RandomStream random, SceneBuilder& out);

}  // namespace jalon
