// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "cli/table.h"

namespace jalon::cli {

/// A depth image from where raster_growing looks, drawn for itself, as a PNG of 16 bits or a GeoTIFF of metres:
/// "--raster", "--raster-tif".
struct RasterFile {
  bool png = false, tif = false;

  bool wanted() const { return png || tif; }

  void add_to(Command& command) {
    command.flag("--raster", png,
                 "Method raster_growing: write a depth image from where it looks too, raster.png, "
                 "which can be segmented again");
    command.flag("--raster-tif", tif, "The same as GeoTIFF with depths in metres, raster.tif");
  }
  void check(const std::string& method) const {
    if (wanted() && method != "raster_growing")
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "--raster and --raster-tif are for --method raster_growing"};
  }
  /// The files, where path_of a name says: of the given plane of projection, else of the largest segment's. Their
  /// names, none where none was asked for.
  std::vector<std::string> write(const Console& console, const Cloud& cloud, const Params& method,
                                 const Table& segments,
                                 const std::function<std::string(const char*)>& path_of) const {
    if (!wanted()) return {};
    const char* projection = nullptr;
    const double* given = nullptr;
    uint64_t count = 0;
    double pixel_m = 0;
    must(jalon_params_get_string(method.get(), "projection", &projection));
    must(jalon_params_get_doubles(method.get(), "direction", &given, &count));
    must(jalon_params_get_double(method.get(), "pixel_m", &pixel_m));
    std::vector<double> direction(given, given + count);
    if (std::string_view(projection) != "given")
      for (const uint32_t k : {0u, 1u, 2u}) direction[k] = segments.number("normal", 0, k);
    const Params options = make_params("write");
    must(jalon_params_set_doubles(options.get(), "png_direction", direction.data(),
                                  direction.size()));
    must(jalon_params_set_double(options.get(), "png_pixel_m", pixel_m));
    std::vector<std::string> names;
    if (png) names.emplace_back("raster.png");
    if (tif) names.emplace_back("raster.tif");
    for (const std::string& name : names)
      must(jalon_cloud_write(cloud.get(), path_of(name.c_str()).c_str(), options.get(),
                             console.task()));
    return names;
  }
};

}  // namespace jalon::cli
