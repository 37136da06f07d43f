// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/edge_curve.h"

#include "cli/table.h"

namespace jalon::cli {

namespace {

// Where the contour points are, for programs that draw.
std::string places_csv(const Segmentation& segmentation, const Table& points) {
  Cloud cloud;
  must(jalon_segmentation_cloud(segmentation.get(), Out(cloud)));
  jalon_array_view view;
  must(jalon_cloud_points(cloud.get(), &view));
  const auto* xyz = static_cast<const double*>(view.data);
  std::string text = "point,x,y,z\n";
  for (uint64_t row = 0; row < points.rows(); ++row) {
    const uint64_t i = points.count("point", row);
    text += std::to_string(i);
    for (uint64_t k = 0; k < 3; ++k) text += "," + fixed(xyz[3 * i + k], 4);
    text += "\n";
  }
  return text;
}

}  // namespace

void EdgeCurveFiles::add_to(Command& command) {
  command
      .option(
          "--edge-curve", label,
          "Write the sorted edge lengths of this plane's triangulation and the end points of its "
          "long edges too: edge_lengths.csv, contour_points.csv")
      .positive()
      .type_name("LABEL");
  command
      .option("--edge-threshold", threshold_m,
              "Edges longer than this are long (m); default: where the curve turns")
      .positive();
}

void EdgeCurveFiles::check() const {
  if (label == 0 && threshold_m > 0)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--edge-threshold is for --edge-curve"};
}

std::vector<std::string> EdgeCurveFiles::write(
    const Console& console, const Segmentation& segmentation,
    const std::function<std::string(const char*)>& path_of) const {
  if (label == 0) return {};
  const Params options = make_params("long_edges");
  if (threshold_m > 0) must(jalon_params_set_double(options.get(), "threshold_m", threshold_m));
  Fields lengths, points, summary;
  must(jalon_segmentation_long_edges(segmentation.get(), static_cast<uint32_t>(label),
                                     options.get(), console.task(), Out(lengths), Out(points),
                                     Out(summary)));
  const Table told(std::move(summary)), ends(std::move(points));
  write_text_file(path_of("edge_lengths.csv"), Table(std::move(lengths)).csv());
  write_text_file(path_of("contour_points.csv"), places_csv(segmentation, ends));
  console.say("edges of " + std::to_string(label) + ": " + grouped(told.count("edges", 0)) +
              ", spacing " + fixed(told.number("spacing", 0), 4) + ", the curve turns at " +
              fixed(told.number("knee", 0), 4) + "; " + grouped(told.count("longer", 0)) +
              " beyond " + fixed(told.number("threshold", 0), 4) + " end at " +
              grouped(told.count("points", 0)) + " contour points");
  return {"edge_lengths.csv", "contour_points.csv"};
}

}  // namespace jalon::cli
