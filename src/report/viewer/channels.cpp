// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/viewer/channels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jalon {

namespace {

constexpr size_t kSample = 50000;
constexpr double kShareOfScale = 0.02, kShareOfStrays = 0.01;

// The values at a share and at the rest of it among evenly taken ones; NaN are left out.
template <class F>
std::pair<double, double> quantiles(size_t n, double share, F&& value) {
  const size_t stride = n / kSample + 1;
  std::vector<double> values;
  for (size_t i = 0; i < n; i += stride)
    if (const double v = value(i); std::isfinite(v)) values.push_back(v);
  if (values.empty()) return {0, 0};
  std::sort(values.begin(), values.end());
  const auto low = static_cast<size_t>(share * static_cast<double>(values.size() - 1));
  return {values[low], values[values.size() - 1 - low]};
}

const Column* scalar(const Cloud& cloud, const char* name) {
  const Column* column = cloud.fields.find(name);
  return column != nullptr && column->info().components == 1 ? column : nullptr;
}

void add_intensity(ViewCloud& view) {
  const Column* intensity = scalar(*view.cloud, "intensity");
  if (intensity == nullptr) return;
  const auto value = [intensity](size_t i) { return intensity->number(i); };
  const auto [low, high] = quantiles(view.cloud->size(), kShareOfScale, value);
  if (!(high > low)) return;
  ViewChannel channel;
  channel.name = "intensity";
  channel.low = low;
  channel.high = high;
  constexpr int kGreys = 64, kDarkest = 20, kBrightest = 245;
  for (int g = 0; g < kGreys; ++g) {
    const auto grey = static_cast<uint8_t>(kDarkest + (kBrightest - kDarkest) * g / (kGreys - 1));
    channel.colours.push_back({grey, grey, grey});
  }
  channel.none = {{{0xb4, 0xb4, 0xb4}, ""}};
  channel.value = value;
  view.channels.push_back(std::move(channel));
}

void add_colour(ViewCloud& view) {
  const Column *red = scalar(*view.cloud, "red"), *green = scalar(*view.cloud, "green"),
               *blue = scalar(*view.cloud, "blue");
  if (red == nullptr || green == nullptr || blue == nullptr) return;
  double most = 0;
  const size_t stride = view.cloud->size() / kSample + 1;
  for (size_t i = 0; i < view.cloud->size(); i += stride)
    most = std::max({most, red->number(i), green->number(i), blue->number(i)});
  const double unit = most > 255 ? 1.0 / 256 : most > 1 ? 1 : 255;  // floats go from 0 to 1
  ViewChannel channel;
  channel.kind = ViewChannel::Kind::kColour;
  channel.name = "colour";
  channel.value = [red, green, blue, unit](size_t i) {
    double out = 0;
    for (const Column* part : {red, green, blue})
      out = out * 256 + std::clamp(std::floor(part->number(i) * unit), 0.0, 255.0);
    return out;
  };
  view.channels.push_back(std::move(channel));
}

}  // namespace

void add_field_channels(ViewCloud& view) {
  add_intensity(view);
  add_colour(view);
}

Box3 box_without_strays(const Cloud& cloud, const Transform& pose) {
  Box3 box;
  if (cloud.size() == 0) return box;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = quantiles(cloud.size(), kShareOfStrays,
                                       [&](size_t i) { return pose.point(cloud.point(i))[k]; });
    box.min[k] = low;
    box.max[k] = high;
  }
  return box;
}

}  // namespace jalon
