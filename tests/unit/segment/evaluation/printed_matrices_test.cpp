// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "segment/evaluation/confusion.h"

using namespace jalon;

// The confusion matrices of the master's thesis on feature codes for terrestrial laser scanning (University of Liege
// 2021, tables 4, 6, 8 and 9; classes rest, walls, doors, windows, gutters) and what its tables 5, 7 and 10 print of
// them. Two cells are corrected, as their row sums and the printed rates demand: walls of table 6 (11,376,605 in print)
// and walls taken for doors in table 8 (51,414 in print).
namespace {

struct Printed {
  const char* name;
  std::vector<uint64_t> counts;
  double accuracy_percent;
  std::vector<double> precision, recall, f1;
  double mean_precision, mean_recall, mean_f1;
};

const Printed kPrinted[] = {
    {"building, targets",
     {22819476, 205993, 35973, 155238, 353555, 11351059, 22373, 29275, 7907, 512, 236413, 0, 72636,
      0, 0, 496520},
     97.5,
     {0.981, 0.982, 0.802, 0.729},
     {0.983, 0.966, 0.966, 0.872},
     {0.982, 0.974, 0.876, 0.794},
     0.873,
     0.947,
     0.907},
    {"building, survey",
     {22916813, 136966, 36139, 126762, 4170, 11676605, 4774, 70713, 0, 9306, 235526, 0, 7709, 5375,
      0, 556072},
     98.9,
     {0.999, 0.987, 0.852, 0.738},
     {0.987, 0.993, 0.962, 0.977},
     {0.993, 0.990, 0.904, 0.841},
     0.894,
     0.980,
     0.932},
    {"facades, targets",
     {74072447, 241453, 29097, 408507, 916, 562294, 12811151, 15709, 51414,
      3574,     7533,   43300, 159831, 0,   0,      56956,    0,     0,
      691796,   0,      4901,  22296,  0,   0,      29895},
     98.4,
     {0.991, 0.977, 0.781, 0.601, 0.869},
     {0.991, 0.953, 0.759, 0.924, 0.524},
     {0.991, 0.965, 0.770, 0.728, 0.654},
     0.844,
     0.830,
     0.822},
    {"facades, survey",
     {74327659, 186663, 36927, 200829, 342, 40333,  13270620, 16778, 105748, 10663, 0, 3270, 207394,
      0,        0,      1455,  45035,  0,   702262, 0,        157,   11606,  0,     0, 45329},
     99.2,
     {0.999, 0.982, 0.794, 0.696, 0.804},
     {0.994, 0.987, 0.984, 0.938, 0.794},
     {0.997, 0.984, 0.879, 0.799, 0.799},
     0.855,
     0.939,
     0.892},
};

// The print rounds most figures, cuts some and takes means of rounded ones: a fifth of a digit more than rounding
// allows.
void same_digit(double value, double printed) { CHECK(std::fabs(value - printed) <= 0.0007); }

}  // namespace

TEST_CASE("confusion__printed_matrices_give_every_printed_figure") {
  for (const Printed& p : kPrinted) {
    CAPTURE(p.name);
    Confusion c;
    const size_t n = p.precision.size();
    REQUIRE(p.counts.size() == n * n);
    for (size_t i = 0; i < n; ++i) c.classes.push_back(static_cast<int64_t>(i));
    c.counts = p.counts;
    for (const uint64_t count : p.counts) c.points += count;
    const FieldTable classes = class_table(c), totals = agreement_table(c);
    const auto column = [&](const FieldTable& table, const char* name, size_t row) {
      return table.require(name).values<double>()[row];
    };
    for (size_t i = 0; i < n; ++i) {
      CAPTURE(i);
      same_digit(column(classes, "precision", i), p.precision[i]);
      same_digit(column(classes, "recall", i), p.recall[i]);
      same_digit(column(classes, "f1", i), p.f1[i]);
    }
    CHECK(std::fabs(100 * column(totals, "accuracy", 0) - p.accuracy_percent) <= 0.07);
    same_digit(column(totals, "mean_precision", 0), p.mean_precision);
    same_digit(column(totals, "mean_recall", 0), p.mean_recall);
    same_digit(column(totals, "mean_f1", 0), p.mean_f1);
  }
}
