// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/clearance_drawing.h"

#include <algorithm>
#include <cmath>

#include "cli/console.h"

namespace jalon::cli {

namespace {

// Of the drawing, in pixels.
constexpr double kWidth = 1000, kHeight = 420, kLeft = 70, kRight = 20, kTop = 46, kBottom = 50;
constexpr size_t kMostBars =
    900;  ///< a bar a pixel: more intervals share one, and the least of them is drawn

struct Scale {
  double low, high;
  double y(double clearance_m) const {
    return kTop +
           (high - std::clamp(clearance_m, low, high)) / (high - low) * (kHeight - kTop - kBottom);
  }
};

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line x1=\"" + fixed(x1, 1) + "\" y1=\"" + fixed(y1, 1) + "\" x2=\"" + fixed(x2, 1) +
         "\" y2=\"" + fixed(y2, 1) + "\" " + style + "/>\n";
}

std::string label(double x, double y, const std::string& anchor, const std::string& text) {
  return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" + anchor +
         "\">" + text + "</text>\n";
}

// Steps of 1, 2 or 5 times a power of ten, about six of them.
double step_of(double span) {
  const double power = std::pow(10, std::floor(std::log10(span / 6)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (span / (factor * power) <= 7) return factor * power;
  return 10 * power;
}

const char* colour_of(double clearance_m, double margin_m) {
  return clearance_m <= 0 ? "#c0392b" : clearance_m <= margin_m ? "#e08e0b" : "#2e7d52";
}

std::string bars(const std::vector<double>& clearances, double margin_m, const Scale& scale) {
  const size_t n = clearances.size(), count = std::min(n, kMostBars);
  const double width = (kWidth - kLeft - kRight) / static_cast<double>(count);
  std::string out;
  for (size_t b = 0; b < count; ++b) {
    double least = scale.high;
    bool known = false;
    for (size_t i = b * n / count; i < (b + 1) * n / count; ++i) {
      if (!std::isfinite(clearances[i])) continue;
      least = std::min(least, clearances[i]);
      known = true;
    }
    if (!known) continue;
    const double top = scale.y(std::max(least, 0.0)), bottom = scale.y(std::min(least, 0.0));
    out += "<rect x=\"" + fixed(kLeft + width * static_cast<double>(b), 2) + "\" y=\"" +
           fixed(top, 2) + "\" width=\"" + fixed(std::max(width, 0.6), 2) + "\" height=\"" +
           fixed(std::max(bottom - top, 1.5), 2) + "\" fill=\"" + colour_of(least, margin_m) +
           "\"/>\n";
  }
  return out;
}

std::string axes(size_t intervals, const Scale& scale, const std::string& unit) {
  std::string out;
  const double step = step_of(scale.high - scale.low);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  for (double v = std::ceil(scale.low / step - 1e-9) * step; v <= scale.high * (1 + 1e-9);
       v += step) {
    out += line(kLeft, scale.y(v), kWidth - kRight, scale.y(v), "stroke=\"#dddddd\"");
    out += label(kLeft - 6, scale.y(v) + 4, "end", fixed(std::abs(v) < step / 2 ? 0 : v, decimals));
  }
  const double along = std::max(1.0, step_of(static_cast<double>(intervals)));
  for (double p = 0; p <= static_cast<double>(intervals); p += along) {
    const double x = kLeft + (kWidth - kLeft - kRight) * p / static_cast<double>(intervals);
    out += line(x, kHeight - kBottom, x, kHeight - kBottom + 5, "stroke=\"#333333\"");
    out += label(x, kHeight - kBottom + 19, "middle", fixed(p, 0));
  }
  return out + label((kLeft + kWidth - kRight) / 2, kHeight - 12, "middle", "pose") +
         label(kLeft - 6, kTop - 12, "end", unit);
}

}  // namespace

std::string clearance_drawing(const std::vector<double>& clearances, double margin_m,
                              double reach_m, const std::string& unit) {
  Scale scale{0, std::max({reach_m, margin_m, 1e-3})};
  for (const double c : clearances)
    if (std::isfinite(c)) scale.low = std::min(scale.low, c);
  if (scale.low < 0) scale.low -= 0.03 * (scale.high - scale.low);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed(kWidth, 0) +
                    " " + fixed(kHeight, 0) +
                    "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  svg += label(kLeft, 20, "start",
               "Least clearance of the gauge from each pose to the next; blank: above " +
                   fixed(scale.high, 2) + " " + unit + "; dashed: the margin, " +
                   fixed(margin_m, 3) + " " + unit);
  svg += axes(clearances.size(), scale, unit) + bars(clearances, margin_m, scale);
  svg += line(kLeft, scale.y(0), kWidth - kRight, scale.y(0), "stroke=\"#333333\"");
  const double y = scale.y(margin_m);
  svg += line(kLeft, y, kWidth - kRight, y, "stroke=\"#c0392b\" stroke-dasharray=\"6 4\"");
  return svg + "</svg>\n";
}

}  // namespace jalon::cli
