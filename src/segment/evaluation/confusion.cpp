// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/evaluation/confusion.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "segment/labels/whole_numbers.h"
#include "segment/labels/key_counts.h"

namespace jalon {

namespace {

constexpr size_t kMaxClasses = 1024;  // a matrix of 8 MiB; more are no classes but instances

double ratio_of_confusion(double a, double b) { return b > 0 ? a / b : kNaN; }
double ratio_of_confusion(uint64_t a, uint64_t b) {
  return ratio_of_confusion(static_cast<double>(a), static_cast<double>(b));
}

// Row, column and diagonal sums of one class.
struct ClassCounts {
  uint64_t support = 0, predicted = 0, correct = 0;
  double precision() const { return ratio_of_confusion(correct, predicted); }
  double recall() const { return ratio_of_confusion(correct, support); }
  double f1() const {
    return ratio_of_confusion(2 * correct, support + predicted);
  }  // 2 TP / (2 TP + FP + FN)
  double iou() const { return ratio_of_confusion(correct, support + predicted - correct); }
};

std::vector<ClassCounts> counts_of(const Confusion& c) {
  std::vector<ClassCounts> out(c.size());
  for (size_t r = 0; r < c.size(); ++r)
    for (size_t p = 0; p < c.size(); ++p) {
      out[r].support += c.count(r, p);
      out[p].predicted += c.count(r, p);
      if (r == p) out[r].correct = c.count(r, p);
    }
  return out;
}

// The classes that the points counted have in either field, as keys.
std::vector<uint64_t> classes_of(const WholeNumbers& a, const WholeNumbers& b, size_t n,
                                 Task& task) {
  std::vector<uint64_t> out;
  for (const auto& [field, other, from] : {std::tuple{&a, &b, 0.0}, std::tuple{&b, &a, 0.5}}) {
    ProgressSpan span(task, from, from + 0.5);
    const auto counts =
        count_keys(task, n, [f = field, o = other](size_t begin, size_t end, uint64_t* keys) {
          std::vector<uint64_t> others(end - begin);
          f->keys(begin, end, keys);
          o->keys(begin, end, others.data());
          for (size_t i = 0; i < others.size(); ++i)
            if (others[i] == kNoKey) keys[i] = kNoKey;
        });
    for (const KeyCount& c : counts) out.push_back(c.key);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (out.size() > kMaxClasses)
    fail(Status::kLimit, "%zu classes; at most %zu are told apart: are these numbers of instances?",
         out.size(), kMaxClasses);
  return out;
}

template <class T, class F>
void add(FieldTable& table, size_t rows, uint32_t components, const char* name, const char* unit,
         const char* meaning, F&& value) {
  auto column = std::make_shared<Column>(
      FieldInfo{name, element_type_of<T>(), components, unit, meaning}, rows);
  const auto out = column->template values<T>();
  for (size_t i = 0; i < rows; ++i)
    for (uint32_t k = 0; k < components; ++k) out[i * components + k] = static_cast<T>(value(i, k));
  table.set(column);
}

constexpr auto kConfusionRows = setting_rows(doubles_row<&ConfusionSettings::ignored_classes>(
    "ignored_classes", -kWholeDoubles, kWholeDoubles, "1", "",
    "Points of these reference classes are left out, e.g. 0 where it means unclassified."));

}  // namespace

std::span<const ParamRow> confusion_rows() { return kConfusionRows; }

Confusion confusion_of(const Cloud& cloud, std::string_view predicted, std::string_view reference,
                       const ConfusionSettings& settings, Task& task) {
  const WholeNumbers found(cloud.fields.require(predicted), {});
  const WholeNumbers truth(cloud.fields.require(reference), settings.ignored_classes);
  const size_t n = cloud.size();
  const std::vector<uint64_t> classes = [&] {
    ProgressSpan span(task, 0, 0.6, "counting classes");
    return classes_of(found, truth, n, task);
  }();
  const auto index_of = [&](uint64_t key) {
    return static_cast<uint64_t>(std::lower_bound(classes.begin(), classes.end(), key) -
                                 classes.begin());
  };
  Confusion out;
  for (const uint64_t key : classes) out.classes.push_back(WholeNumbers::value_of(key));
  out.counts.assign(classes.size() * classes.size(), 0);
  ProgressSpan span(task, 0.6, 1, "counting points");
  const auto cells = count_keys(task, n, [&](size_t begin, size_t end, uint64_t* keys) {
    std::vector<uint64_t> truths(end - begin);
    found.keys(begin, end, keys);
    truth.keys(begin, end, truths.data());
    for (size_t i = 0; i < truths.size(); ++i) {
      const bool counts_in = keys[i] != kNoKey && truths[i] != kNoKey;
      keys[i] = counts_in ? index_of(truths[i]) * classes.size() + index_of(keys[i]) : kNoKey;
    }
  });
  for (const KeyCount& cell : cells) {
    out.counts[cell.key] = cell.count;
    out.points += cell.count;
  }
  return out;
}

FieldTable class_table(const Confusion& c) {
  const std::vector<ClassCounts> counts = counts_of(c);
  const size_t n = counts.size();
  FieldTable t;
  const auto rate = [&](const char* name, const char* meaning,
                        double (ClassCounts::*value)() const) {
    add<double>(t, n, 1, name, "1", meaning,
                [&](size_t i, uint32_t) { return (counts[i].*value)(); });
  };
  add<int64_t>(t, n, 1, "class", "", "value of the class fields",
               [&](size_t i, uint32_t) { return c.classes[i]; });
  add<uint64_t>(t, n, 1, "reference", "points", "points of the class in the reference",
                [&](size_t i, uint32_t) { return counts[i].support; });
  add<uint64_t>(t, n, 1, "predicted", "points", "points given the class",
                [&](size_t i, uint32_t) { return counts[i].predicted; });
  add<uint64_t>(t, n, 1, "correct", "points", "points of both",
                [&](size_t i, uint32_t) { return counts[i].correct; });
  rate("precision", "correct / predicted", &ClassCounts::precision);
  rate("recall", "correct / reference", &ClassCounts::recall);
  rate("f1", "harmonic mean of precision and recall", &ClassCounts::f1);
  rate("iou", "intersection over union", &ClassCounts::iou);
  add<uint64_t>(t, n, static_cast<uint32_t>(std::max<size_t>(1, n)), "confusion", "points",
                "points of the row's reference class given each class, in the order of the rows",
                [&](size_t i, uint32_t k) { return c.count(i, k); });
  return t;
}

FieldTable agreement_table(const Confusion& c) {
  uint64_t correct = 0;
  double precision = 0, recall = 0, f1 = 0, present = 0, chance = 0;
  for (const ClassCounts& k : counts_of(c)) {
    correct += k.correct;
    chance += static_cast<double>(k.support) * static_cast<double>(k.predicted);
    if (k.support == 0) continue;  // only ever given: it costs the others their recall
    present += 1;
    precision += k.predicted > 0 ? k.precision() : 0;
    recall += k.recall();
    f1 += k.f1();
  }
  const double n = static_cast<double>(c.points), by_chance = ratio_of_confusion(chance, n * n),
               accuracy = ratio_of_confusion(correct, c.points);
  FieldTable t;
  const auto number = [&](const char* name, const char* meaning, double value) {
    add<double>(t, 1, 1, name, "1", meaning, [&](size_t, uint32_t) { return value; });
  };
  add<uint64_t>(t, 1, 1, "points", "points", "points compared",
                [&](size_t, uint32_t) { return c.points; });
  add<uint64_t>(t, 1, 1, "correct", "points", "points of equal class",
                [&](size_t, uint32_t) { return correct; });
  number("accuracy", "correct / points; also precision, recall and F1 over all points", accuracy);
  number("mean_precision",
         "mean over the reference's classes; a class that was never given counts 0",
         ratio_of_confusion(precision, present));
  number("mean_recall", "mean over the reference's classes", ratio_of_confusion(recall, present));
  number("mean_f1", "mean over the reference's classes", ratio_of_confusion(f1, present));
  number("kappa", "agreement beyond chance (Cohen 1960)",
         ratio_of_confusion(accuracy - by_chance, 1 - by_chance));
  return t;
}

}  // namespace jalon
