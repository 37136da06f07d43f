// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/orthoimage.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "model/part_classes.h"
#include "report/pictures/deviation_colours.h"
#include "report/pictures/ortho_points.h"

namespace jalon {

namespace {

constexpr auto kOrthoimageRows = setting_rows(
    integer_row<&OrthoimageSettings::facade>(
        "facade", 0, 1e9, "", "",
        "The k-th part of class facade; 0: that with the largest front wall"),
    choice_row<&OrthoimageSettings::content>(
        "content", "auto|colour|intensity|distance", "",
        "What pixels show; auto: the first of these that the cloud has; distance: before the front "
        "plane"),
    number_row<&OrthoimageSettings::pixel_m>(
        "pixel_m", 0, 10, "m", "",
        "Side of a pixel; 0: one and a half times the mean spacing of the points, in whole "
        "millimetres"),
    number_row<&OrthoimageSettings::in_front_m>("in_front_m", 0, 1000, "m", "",
                                                "How far before the front plane points are shown"),
    number_row<&OrthoimageSettings::behind_m>("behind_m", 0, 1000, "m", "",
                                              "How far behind the front plane points are shown"),
    integer_row<&OrthoimageSettings::fill>(
        "fill", 0, 100, "", "",
        "How often a pixel without points gets the mean of its neighbours where five of the eight "
        "have data"));

constexpr double kOrthoPixel_spacings =
    1.5;                                 // nine pixels of ten have points when these lie at random
constexpr double kStep_m = 0.001;        // of pixels whose size was left open
constexpr double kShareOfStrays = 0.02;  // of the values at either end of a scale of greys
constexpr double kShareOfDistances = 0.98;  // within the ends of a scale of distances
constexpr double kLeastScale_m = 0.02;      // so that the noise of a bare wall looks like none
constexpr int kClosing = 5;                 // of 8 neighbours

// The k-th facade of the tree, or the one with the largest front.
const PlacedFacade& chosen(const std::vector<PlacedFacade>& facades, const Model& model,
                           int64_t k) {
  if (facades.empty())
    fail(Status::kDegenerate, "the model has no upright face that an orthoimage could show");
  if (k == 0)
    return *std::ranges::max_element(facades, {}, [](const PlacedFacade& f) {
      return (f.right_m - f.left_m) * (f.top_m - f.bottom_m);
    });
  int64_t count = 0;
  for (uint32_t part = 0; part < model.parts.size(); ++part) {
    if (model.parts[part].part_class != part_class::kFacade || ++count != k) continue;
    for (const PlacedFacade& facade : facades)
      if (facade.facade == part) return facade;
    fail(Status::kDegenerate, "facade %lld has no upright face", static_cast<long long>(k));
  }
  fail(Status::kInvalidArgument, "facade %lld of a model that has %lld", static_cast<long long>(k),
       static_cast<long long>(count));
}

double pixel_of(const PlacedFacade& facade, const OrthoimageSettings& settings,
                const OrthoPoints& points, double most_pixels, Task& task) {
  const double width_m = facade.right_m - facade.left_m, height_m = facade.top_m - facade.bottom_m;
  const double least_m = std::sqrt((width_m + kStep_m) * (height_m + kStep_m) / most_pixels);
  if (settings.pixel_m > 0) {
    if (settings.pixel_m < least_m)
      fail(Status::kLimit, "pixels of %s m are too many for %s x %s m: %s m is the least",
           text_of(settings.pixel_m).c_str(), text_of(width_m, 2).c_str(),
           text_of(height_m, 2).c_str(),
           text_of(std::ceil(least_m / kStep_m) * kStep_m, 3).c_str());
    return settings.pixel_m;
  }
  const double wanted_m = std::max(least_m, kOrthoPixel_spacings * points.spacing_m(task));
  return std::max(1.0, std::ceil(wanted_m / kStep_m)) * kStep_m;
}

// The pixels of the facade's box; their borders are multiples of their side, so that images of equal pixels fit.
void lay_out(Orthoimage& image) {
  const PlacedFacade& f = image.facade;
  const double p = image.pixel_m;
  image.left_m = std::floor(f.left_m / p) * p;
  image.top_m = std::ceil(f.top_m / p) * p;
  image.columns = static_cast<uint32_t>(std::max(1.0, std::ceil((f.right_m - image.left_m) / p)));
  image.rows = static_cast<uint32_t>(std::max(1.0, std::ceil((image.top_m - f.bottom_m) / p)));
}

// Pixels without points that lie within a surface.
void close_holes(Orthoimage& image) {
  const std::vector<uint8_t> before = image.has_data;
  const size_t columns = image.columns;
  const size_t samples = image.content == OrthoContent::kColour ? 3 : 1;
  for (size_t y = 1; y + 1 < image.rows; ++y)
    for (size_t x = 1; x + 1 < columns; ++x) {
      const size_t at = y * columns + x;
      if (before[at] != 0) continue;
      const size_t around[] = {at - columns - 1, at - columns, at - columns + 1, at - 1, at + 1,
                               at + columns - 1, at + columns, at + columns + 1};
      const auto count = std::ranges::count_if(around, [&](size_t i) { return before[i] != 0; });
      if (count < kClosing) continue;
      for (size_t s = 0; s < samples; ++s) {
        double sum = 0;
        for (const size_t i : around)
          if (before[i] != 0) sum += samples == 3 ? image.colours[3 * i + s] : image.values[i];
        const double mean = sum / static_cast<double>(count);
        if (samples == 3) image.colours[3 * at + s] = static_cast<uint8_t>(std::lround(mean));
        else image.values[at] = static_cast<float>(mean);
      }
      image.has_data[at] = 1;
    }
}

std::vector<float> known_values(const Orthoimage& image) {
  std::vector<float> out;
  for (size_t i = 0; i < image.values.size(); ++i)
    if (image.has_data[i] != 0) out.push_back(image.values[i]);
  return out;
}

}  // namespace

std::span<const ParamRow> orthoimage_rows() { return kOrthoimageRows; }

Orthoimage make_orthoimage(const Cloud& cloud, const Model& model,
                           const OrthoimageSettings& settings, double most_pixels, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the orthoimage");
  Orthoimage image;
  image.facade = chosen(facades_side_by_side(model), model, settings.facade);
  const OrthoPoints points(cloud, image.facade, settings, task);
  image.content = points.content();
  image.pixel_m = pixel_of(image.facade, settings, points, most_pixels, task);
  lay_out(image);
  points.draw(image, task);
  for (int64_t k = 0; k < settings.fill; ++k) {
    task.checkpoint(1);
    close_holes(image);
  }
  return image;
}

std::optional<Orthoimage> find_orthoimage(const Cloud& cloud, const Model& model,
                                          const OrthoimageSettings& settings, double most_pixels,
                                          Task& task) {
  try {
    return make_orthoimage(cloud, model, settings, most_pixels, task);
  } catch (const Error& error) {
    if (error.status() != Status::kDegenerate && error.status() != Status::kInsufficientData) throw;
    return {};
  }
}

Rgb OrthoColours::operator()(double value) const {
  if (is_distance) {
    const DeviationScale scale{high, true};
    return scale.colour(scale.step_of(value));
  }
  const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
  const auto grey = static_cast<uint8_t>(std::lround(255 * share));
  return {grey, grey, grey};
}

OrthoColours colours_of(const Orthoimage& image) {
  std::vector<float> values = known_values(image);
  OrthoColours out;
  out.is_distance = image.content == OrthoContent::kDistance;
  if (values.empty()) return out;
  const auto at = [&](double share) {
    const auto place =
        values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return double{*place};
  };
  if (out.is_distance) {
    for (float& v : values) v = std::fabs(v);
    out.high = std::max(at(kShareOfDistances), kLeastScale_m);
    out.low = -out.high;
  } else {
    out.low = at(kShareOfStrays);
    out.high = at(1 - kShareOfStrays);
  }
  return out;
}

RgbaImage rgba_of(const Orthoimage& image) {
  constexpr uint8_t kOpaque = 255;
  const OrthoColours colours = colours_of(image);
  RgbaImage out{image.columns, image.rows, std::vector<uint8_t>(4 * image.size(), 0)};
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.has_data[i] == 0) continue;
    const Rgb c =
        image.content == OrthoContent::kColour
            ? Rgb{image.colours[3 * i], image.colours[3 * i + 1], image.colours[3 * i + 2]}
            : colours(image.values[i]);
    const uint8_t bytes[] = {c.red, c.green, c.blue, kOpaque};
    std::ranges::copy(bytes, out.pixels.begin() + static_cast<ptrdiff_t>(4 * i));
  }
  return out;
}

}  // namespace jalon
