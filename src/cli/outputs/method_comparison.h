// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/system/peak_memory.h"
#include "cli/table.h"

namespace jalon::cli {

/// "--compare-methods": every way to find planes on one scan, as one table and one page.
struct MethodComparison {
  bool wanted = false;
  std::string labels;  ///< field of the true segments; "" = none

  void add_to(Command& command) {
    command.flag("--compare-methods", wanted,
                 "Run every method with its defaults instead, and compare: methods.csv, "
                 "methods.json, methods.html and a picture of each");
    command
        .option("--reference-labels", labels,
                "Field with the true segments, for --compare-methods: TDR and TDA against them")
        .type_name("FIELD");
  }
  void check() const {
    if (!wanted && !labels.empty())
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--reference-labels is for --compare-methods"};
  }

  struct Row {
    std::string method, why_not;  ///< why_not: what the method lacks
    double seconds = 0, share = 0, sigma = NAN, tdr = NAN, tda = NAN;
    double memory = NAN;  ///< bytes at its peak beyond those of the cloud
    uint64_t planes = 0;
  };

  /// The table for people, heading first.
  static std::vector<std::string> lines(const std::vector<Row>& rows) {
    std::vector<std::string> out{
        "method             planes   share   sigma mm      TDR      TDA   seconds        MB"};
    for (const Row& r : rows) {
      char line[200];
      if (!r.why_not.empty())
        std::snprintf(line, sizeof line, "%-17s not: %.150s", r.method.c_str(), r.why_not.c_str());
      else
        std::snprintf(line, sizeof line, "%-17s %7llu %7s %10s %8s %8s %9s %9s", r.method.c_str(),
                      static_cast<unsigned long long>(r.planes), fixed(r.share, 3).c_str(),
                      told(1000 * r.sigma, 2).c_str(), told(r.tdr, 3).c_str(),
                      told(r.tda, 3).c_str(), fixed(r.seconds, 2).c_str(),
                      told(r.memory * 1e-6, 0).c_str());
      out.push_back(line);
    }
    return out;
  }

  static nlohmann::ordered_json json(const std::vector<Row>& rows) {
    auto list = nlohmann::ordered_json::array();
    const auto number = [](double v) {
      return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
    };
    for (const Row& r : rows)
      list.push_back({{"method", r.method},
                      {"unsupported", r.why_not},
                      {"planes", r.planes},
                      {"share", r.share},
                      {"sigma", number(r.sigma)},
                      {"tdr", number(r.tdr)},
                      {"tda", number(r.tda)},
                      {"seconds", r.seconds},
                      {"memory_bytes", number(r.memory)}});
    return list;
  }

  static std::string csv(const std::vector<Row>& rows) {
    std::string text = "method,planes,share,sigma,tdr,tda,seconds,memory_bytes\n";
    for (const Row& r : rows) {
      text += r.method;
      if (!r.why_not.empty()) text += ",,,,,,,\n";
      else
        text += "," + std::to_string(r.planes) + "," + fixed(r.share, 6) + "," +
                told(r.sigma, 7, "") + "," + told(r.tdr, 6, "") + "," + told(r.tda, 6, "") + "," +
                fixed(r.seconds, 3) + "," + told(r.memory, 0, "") + "\n";
    }
    return text;
  }

  /// Which one suits. Against true segments the one that finds most of them and invents least (F1 of TDR and TDA), and
  /// those as good that are faster; without them no figure of the table tells planes from chance, and what was measured
  /// where truth is known has to do (tests/bench/METHODS.md).
  static std::string advice(const std::vector<Row>& rows) {
    constexpr double kAsGood = 0.01;  // of F1, by choice: about one segment of a hundred
    const auto score = [](const Row& r) {
      const double sum = r.tdr + r.tda;
      return sum > 0 ? 2 * r.tdr * r.tda / sum : 0.0;
    };
    const Row* best = nullptr;
    for (const Row& r : rows)
      if (std::isfinite(r.tdr) && (best == nullptr || score(r) > score(*best))) best = &r;
    if (best == nullptr || score(*best) == 0)
      return "Without true segments (--reference-labels) no figure tells which planes are right; "
             "where they are known, ransac and region_growing are the best on most scenes. Look at "
             "the pictures.";
    std::string text = "Nearest to the true segments: " + best->method + " (F1 of TDR and TDA " +
                       fixed(score(*best), 3) + ")";
    std::string faster;
    for (const Row& r : rows)
      if (&r != best && score(r) >= score(*best) - kAsGood && r.seconds < best->seconds)
        faster += (faster.empty() ? "" : ", ") + r.method + " (" + fixed(score(r), 3) + ")";
    return text + (faster.empty() ? "." : "; as good and faster: " + faster + ".");
  }

  /// The table and the pictures, which lie beside the page.
  static std::string page(const std::string& title, const std::vector<Row>& rows) {
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Methods</title>\n"
        "<style>body{font-family:sans-serif;margin:2em}td,th{padding:.2em .8em;text-align:right}"
        "td:first-child{text-align:left}img{max-width:100%}</style></head><body>\n<h1>" +
        escaped(title) +
        "</h1>\n<table>\n<tr><th>method</th><th>planes</th><th>share of points</th>"
        "<th>sigma, mm</th><th>TDR</th><th>TDA</th><th>seconds</th><th>MB</th></tr>\n";
    for (const Row& r : rows) {
      text += "<tr><td>" + r.method + "</td>";
      if (!r.why_not.empty()) text += "<td colspan=\"7\">" + escaped(r.why_not) + "</td></tr>\n";
      else
        text += "<td>" + std::to_string(r.planes) + "</td><td>" + fixed(r.share, 3) + "</td><td>" +
                told(1000 * r.sigma, 2) + "</td><td>" + told(r.tdr, 3) + "</td><td>" +
                told(r.tda, 3) + "</td><td>" + fixed(r.seconds, 2) + "</td><td>" +
                told(r.memory * 1e-6, 0) + "</td></tr>\n";
    }
    text += "</table>\n<p>" + escaped(advice(rows)) + "</p>\n";
    for (const Row& r : rows)
      if (r.planes > 0)
        text += "<h2>" + r.method + "</h2>\n<img src=\"" + r.method + ".svg\" alt=\"segments of " +
                r.method + "\">\n";
    return text + "</body></html>\n";
  }

  /// Runs one method; nothing for those that need more than a scan (a list of codes).
  std::optional<Row> run(const Console& console, const std::string& method, const Cloud& cloud,
                         const jalon_segmentation* reference, double tolerance_m,
                         Segmentation& segmentation) const {
    Segmenter worker;
    Params params;
    must(jalon_segmenter_create(method.c_str(), Out(worker)));
    must(jalon_segmenter_params(worker.get(), Out(params)));
    const char* codes = nullptr;
    if (jalon_params_get_string(params.get(), "codes", &codes) == JALON_OK) return {};
    if (tolerance_m > 0)
      must(jalon_params_set_double(params.get(), "distance_tolerance_m", tolerance_m));
    Row row;
    row.method = method;
    const PeakMemory memory;
    const jalon_status status =
        jalon_segmenter_run(worker.get(), cloud.get(), console.task(), Out(segmentation));
    row.seconds = console.seconds();
    if (status == JALON_ERROR_UNSUPPORTED) {
      row.why_not = jalon_last_error_message();
      return row;
    }
    row.memory = memory.peak_bytes();
    must(status);
    Fields fields;
    must(jalon_segmentation_segments(segmentation.get(), Out(fields)));
    const Table table(std::move(fields));
    double points = 0, squares = 0;
    for (uint64_t i = 0; i < table.rows(); ++i) {
      const double n = table.number("inliers", i), sigma = table.number("sigma", i);
      points += n;
      squares += n * sigma * sigma;
    }
    row.planes = table.rows();
    row.share = points / static_cast<double>(count_of(cloud));
    if (points > 0) row.sigma = std::sqrt(squares / points);
    if (reference != nullptr) judge(console, segmentation, reference, row);
    return row;
  }

 private:
  static std::string told(double v, int decimals, const char* none = "-") {
    return std::isfinite(v) ? fixed(v, decimals) : none;
  }
  static std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (c == '<') out += "&lt;";
      else if (c == '&') out += "&amp;";
      else out += c;
    }
    return out;
  }
  static void judge(const Console& console, const Segmentation& segmentation,
                    const jalon_segmentation* reference, Row& row) {
    Evaluation evaluation;
    must(jalon_segmentation_evaluate(segmentation.get(), reference, nullptr, console.task(),
                                     Out(evaluation)));
    Fields fields;
    must(jalon_evaluation_totals(evaluation.get(), Out(fields)));
    const Table totals(std::move(fields));
    row.tdr = totals.number("global_tdr", 0);
    row.tda = totals.number("global_tda", 0);
  }
};

}  // namespace jalon::cli
