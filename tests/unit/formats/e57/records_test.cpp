// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/records.h"

#include <doctest/doctest.h>

#include <bit>

#include "unit/formats/e57/packed_records.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;
using e57::RecordColumn;
using e57::Records;

namespace {

/// Drawn values of columns of each kind, how they are packed, and what must be read.
struct Drawn {
  std::vector<RecordColumn> columns;
  std::vector<BitStream> streams;
  std::vector<std::vector<double>> numbers;
};

Drawn drawn(size_t count, uint64_t seed) {
  Drawn out;
  out.columns = {{kJcDouble, 1, 0, {0, 64}},          {kJcSingle, 1, 0, {0, 32}},
                 {kJcInteger, 1, 0, {-5, 3}},         {kJcScaled, 0.001, 652000, {-70000, 29}},
                 {kJcInteger, 1, 0, {INT64_MIN, 64}}, {kJcInteger, 1, 0, {12, 0}},
                 {kJcScaled, 0.5, 1, {-8, 59}},       {kJcInteger, 1, 0, {0, 1}}};
  out.streams.resize(out.columns.size());
  out.numbers.resize(out.columns.size());
  RandomStream random(seed, 1);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < out.columns.size(); ++c) {
      const auto& [kind, scale, offset, packing] = out.columns[c];
      const double number = random.uniform() * 1e6 - 5e5;
      uint64_t raw = 0;
      for (int k = 0; k < 4; ++k) raw = raw << 16 | static_cast<uint64_t>(random.uniform() * 65536);
      raw = packing.bits == 0 ? 0 : raw >> (64 - packing.bits);
      if (kind == kJcDouble) raw = std::bit_cast<uint64_t>(number);
      if (kind == kJcSingle) raw = std::bit_cast<uint32_t>(static_cast<float>(number));
      out.streams[c].add(raw, packing.bits);
      double wanted = number;
      if (kind == kJcSingle) wanted = static_cast<float>(number);
      const auto whole =
          static_cast<double>(static_cast<int64_t>(static_cast<uint64_t>(packing.least) + raw));
      if (kind == kJcInteger) wanted = whole;
      if (kind == kJcScaled) wanted = whole * scale + offset;
      out.numbers[c].push_back(wanted);
    }
  }
  return out;
}

std::vector<std::vector<double>> read_all(const ByteSource& file, uint64_t section, uint64_t count,
                                          const std::vector<RecordColumn>& columns, Task& task,
                                          size_t& calls) {
  std::vector<std::vector<double>> out(columns.size());
  Records records(file, section, count, columns, task);
  for (calls = 0; const size_t here = records.next(task); ++calls)
    for (size_t c = 0; c < columns.size(); ++c) {
      const size_t done = out[c].size();
      out[c].resize(done + here);
      records.values(c, 0, here / 3, out[c].data() + done);
      records.values(c, here / 3, here - here / 3, out[c].data() + done + here / 3);
    }
  return out;
}

}  // namespace

TEST_CASE("e57_records__values_of_all_kinds_and_widths_come_from_packets_cut_anywhere") {
  const struct {
    size_t count, most, before;
  } kCases[] = {{1, 60, 48}, {700, 9, 1000}, {5000, 3000, 5000}};
  for (const auto& row : kCases) {
    const Drawn data = drawn(row.count, row.count);
    // What is no packet follows at once.
    const OpenedFile file(section_file(row.before, packets_of(data.streams, row.most, row.count),
                                       std::string(3000, '\x77')));
    Task task;
    size_t calls = 0;
    CHECK(read_all(file, row.before + 4 * (row.before / 1020), row.count, data.columns, task,
                   calls) == data.numbers);
  }
}

TEST_CASE("e57_records__of_more_than_a_window_are_the_same_for_any_number_of_threads") {
  const Drawn data = drawn(150000, 3);
  const OpenedFile file(section_file(48, packets_of(data.streams, 7000, 3), ""));
  for (const unsigned threads : {1u, 4u}) {
    Task task(Task::Hooks{.threads = threads});
    size_t calls = 0;
    CHECK(read_all(file, 48, 150000, data.columns, task, calls) == data.numbers);
    CHECK(calls > 1);
  }
}

TEST_CASE("e57_records__what_a_file_lies_about_is_refused_by_offset_and_reason") {
  const std::vector<RecordColumn> two{{kJcInteger, 1, 0, {0, 8}}, {kJcInteger, 1, 0, {0, 8}}};
  const std::string good = data_packet({"abcd", "efgh"});
  const auto changed = [&](size_t at, char byte) {
    std::string out = good;
    out[at] = byte;
    return out;
  };
  const struct {
    std::string packets;
    uint64_t section, count;
    std::vector<RecordColumn> columns;
    const char *place, *reason;
  } kCases[] = {
      {changed(0, 3), 48, 4, two, "offset 80:", "no packet"},
      {changed(2, 18), 48, 4, two, "offset 80:", "no multiple of 4"},
      {changed(4, 3), 48, 4, two, "offset 80:", "one stream for each"},
      {changed(6, 90), 48, 4, two, "offset 80:", "longer than it"},
      {good + other_packet(2, 64), 48, 5, two, "offset 1024:", "before the last 1 points"},
      {good, 47, 4, two, "offset 47:", "no section"},
      {good, 1010, 4, two, "offset 1010:", "behind the end"},
      {good, 5000, 4, two, "offset 5000:", "behind the end"},
      {good, 48, 4, {{kJcInteger, 1, 0, {7, 0}}}, "offset 48:", "takes any bytes"}};
  Task task;
  for (const auto& row : kCases) {
    const char* const reason = row.reason;
    CAPTURE(reason);
    std::string padded = row.packets;  // to the end of the page
    while (padded.size() < 1020 - 80)
      padded += other_packet(2, std::min<size_t>(256, 1020 - 80 - padded.size()));
    const OpenedFile file(section_file(48, padded, ""));
    size_t calls = 0;
    const Failure failure =
        failure_of([&] { read_all(file, row.section, row.count, row.columns, task, calls); });
    CHECK(failure.status == Status::kFormat);
    CHECK(has_text(failure.text, row.place));
    CHECK(has_text(failure.text, reason));
  }
}
