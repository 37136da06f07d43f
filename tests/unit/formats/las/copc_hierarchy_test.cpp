// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Hierarchies that others may write, and ones that lie.
#include <doctest/doctest.h>

#include <atomic>

#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Box3 kCorner{{652000, 6860000, 0}, {652006, 6861002, 104}};

/// A file whose hierarchy is in a tree of pages: that of level 0 names one for each node of level 1.
std::string paged(const std::string& bytes) {
  const std::vector<NodeInFile> nodes = nodes_in(bytes);
  std::string out = bytes;
  const auto add = [&](const las::CopcEntry& entry) {
    std::byte page[las::kCopcEntryBytes];
    las::put_entry(page, entry);
    out.append(reinterpret_cast<const char*>(page), sizeof page);
  };
  std::vector<las::CopcEntry> root = {nodes[0].entry};
  for (const NodeInFile& node : nodes) {
    const las::CopcKey& key = node.entry.key;
    if (key.level != 1) continue;
    las::CopcEntry page{key, out.size(), 0, -1};
    for (const NodeInFile& below : nodes) {
      const las::CopcKey& k = below.entry.key;
      const int up = k.level - 1;
      if (up >= 0 && k.x >> up == key.x && k.y >> up == key.y && k.z >> up == key.z)
        add(below.entry);
    }
    page.bytes = static_cast<int32_t>(out.size() - page.offset);
    root.push_back(page);
  }
  put_at(out, kCopcInfoAt + 40, uint64_t{out.size()});
  put_at(out, kCopcInfoAt + 48, uint64_t{root.size() * las::kCopcEntryBytes});
  for (const las::CopcEntry& entry : root) add(entry);
  return out;
}

template <class T>
std::string with(std::string bytes, size_t at, T value) {
  store<T>(bytes.data() + at, value);
  return bytes;
}

std::string refused(const std::string& bytes) {
  const OpenedFile file(bytes, "a.copc.laz");
  const Failure failure = failure_of([&] { read(file.path(), in_box(kCorner)); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

}  // namespace

TEST_CASE("copc_hierarchy__reads_the_nodes_of_the_box_and_nothing_else_of_the_points") {
  if (lacks_codecs()) return;
  const std::string whole = copc_bytes(wall_and_ground(60000, 21));
  for (const std::string& good : {whole, paged(whole)}) {
    const OpenedFile file(good, "a.copc.laz");
    const Cloud expected = read(file.path(), in_box(kCorner));
    CHECK(expected.size() > 100);
    // All nodes that hold no point of the box and all pages of such nodes are overwritten.
    std::string damaged = good;
    const double half = get_at<double>(whole, kCopcInfoAt + 24);
    const Vec3 low{get_at<double>(whole, kCopcInfoAt) - half,
                   get_at<double>(whole, kCopcInfoAt + 8) - half,
                   get_at<double>(whole, kCopcInfoAt + 16) - half};
    size_t overwritten = 0;
    for (const NodeInFile& node : nodes_in(whole)) {
      const las::CopcKey& key = node.entry.key;
      const double edge = std::ldexp(2 * half, -key.level);
      const Vec3 from = low + Vec3{double(key.x), double(key.y), double(key.z)} * edge;
      bool apart = false;
      for (int k = 0; k < 3; ++k)
        apart = apart || from[k] > kCorner.max[k] + 0.01 || from[k] + edge < kCorner.min[k] - 0.01;
      const auto bytes = static_cast<size_t>(node.entry.bytes);
      if (!apart) continue;
      damaged.replace(node.entry.offset, bytes, bytes, '\xAA');
      ++overwritten;
    }
    CHECK(overwritten > 3);
    const OpenedFile other(damaged, "a.copc.laz");
    const Cloud found = read(other.path(), in_box(kCorner));
    CHECK(ids_of(found) == ids_of(expected));
    CHECK(failure_of([&] { read(other.path()); }).status == Status::kFormat);
  }
}

TEST_CASE("copc_hierarchy__entries_and_pages_that_lie_are_refused_with_their_place") {
  if (lacks_codecs()) return;
  const std::string good = copc_bytes(wall_and_ground(40000, 22));
  const std::vector<NodeInFile> nodes = nodes_in(good);
  const size_t at = nodes[0].at;
  const std::string place = "offset " + std::to_string(at) + ": ";
  const std::string tail = "offset " + std::to_string(at + 16) + ": ";
  const std::string counts = "offset " + std::to_string(at + 24) + ": ";
  for (const int32_t bad : {-1, 32, 0x7FFFFFFF, static_cast<int32_t>(0x80000000)})
    CHECK(has_text(refused(with<int32_t>(good, at, bad)), place + "there is no node"));
  for (const int32_t bad : {-1, 1, 0x7FFFFFFF})
    CHECK(has_text(refused(with<int32_t>(good, at + 4, bad)), place + "there is no node 0-"));
  for (const uint64_t bad : {uint64_t{0}, uint64_t{good.size()}, ~uint64_t{0}, uint64_t{1} << 63})
    CHECK(has_text(refused(with<uint64_t>(good, at + 16, bad)), tail + "the points of a node"));
  for (const int32_t bad : {0, 1, 0x7FFFFFFF})
    CHECK(has_text(refused(with<int32_t>(good, at + 24, bad)), tail + "the points of a node"));
  CHECK(has_text(refused(with<int32_t>(good, at + 24, -5)), counts + "node 0-0-0-0 has"));
  CHECK(has_text(refused(with<int32_t>(good, at + 28, -2)), counts + "node 0-0-0-0 has -2 points"));
  CHECK(has_text(refused(with<int32_t>(good, at + 28, 0x7FFFFFFF)), "more than the file"));
  CHECK(has_text(refused(with<int32_t>(good, at + 28, nodes[0].entry.points - 1)),
                 "the chunk is not one of the"));
  // Two nodes at one place; a file of many points that the entries claim too.
  CHECK(has_text(refused(with<uint64_t>(good, at + 16, nodes[1].entry.offset)), "share"));
  CHECK(
      has_text(refused(with<uint64_t>(with<int32_t>(good, at + 28, 0x7FFFFFFE), 247, ~uint64_t{0})),
               "stand for"));
  const size_t info = kCopcInfoAt;
  for (const uint64_t bad :
       {uint64_t{0}, uint64_t{31}, uint64_t{good.size()} / 32 * 32, ~uint64_t{0}})
    CHECK(has_text(refused(with<uint64_t>(good, info + 48, bad)), "offset 469: a page"));
  for (const uint64_t bad : {uint64_t{good.size()}, ~uint64_t{0}})
    CHECK(has_text(refused(with<uint64_t>(good, info + 40, bad)), "offset 469: a page"));
}

TEST_CASE("copc_hierarchy__pages_that_come_back_to_themselves_end") {
  if (lacks_codecs()) return;
  const std::string good = copc_bytes(wall_and_ground(40000, 23));
  const std::vector<NodeInFile> nodes = nodes_in(good);
  std::byte entry[las::kCopcEntryBytes];
  const auto page = static_cast<int32_t>(nodes.size() * las::kCopcEntryBytes);
  // To its own beginning, and to its own second entry, which is another page of the same kind.
  for (const uint64_t shift : {0u, 32u}) {
    std::string bytes = good;
    las::put_entry(entry, {{}, nodes[0].at + shift, page - static_cast<int32_t>(shift), -1});
    bytes.replace(nodes[0].at, sizeof entry, reinterpret_cast<const char*>(entry), sizeof entry);
    bytes.replace(nodes[1].at, sizeof entry, reinterpret_cast<const char*>(entry), sizeof entry);
    CHECK(has_text(refused(bytes), "is told twice"));
  }
}

TEST_CASE("copc_hierarchy__damaged_bytes_end_in_an_error_or_in_points_and_never_elsewhere") {
  if (lacks_codecs()) return;
  const std::string good = paged(copc_bytes(wall_and_ground(12000, 24)));
  const size_t pages = nodes_in(good)[0].at;
  size_t refusals = 0, tried = 0;
  const auto attempt = [&](size_t at, const char* value, size_t bytes) {
    std::string damaged = good;
    damaged.replace(at, bytes, value, bytes);
    const OpenedFile file(damaged, "a.copc.laz");
    const Failure failure = failure_of([&] { read(file.path(), in_box(kCorner)); });
    CHECK((failure.status == Status::kOk || failure.status == Status::kFormat ||
           failure.status == Status::kUnsupported));
    refusals += failure.status == Status::kOk ? 0 : 1;
    ++tried;
  };
  for (size_t at = kCopcInfoAt; at < kCopcInfoAt + 64; at += 4)
    for (const char* value : {"\0\0\0\0", "\xff\xff\xff\xff", "\xff\xff\xff\x7f", "\0\0\0\x80"})
      attempt(at, value, 4);
  for (size_t at = pages; at + 4 <= good.size(); at += 4)
    for (const char* value : {"\0\0\0\0", "\xff\xff\xff\xff", "\xff\xff\xff\x7f", "\1\0\0\0"})
      attempt(at, value, 4);
  CHECK(tried > 100);
  CHECK(refusals > 50);
}

TEST_CASE("copc_hierarchy__a_cancel_ends_it") {
  if (lacks_codecs()) return;
  const OpenedFile file(copc_bytes(wall_and_ground(12000, 25)), "a.copc.laz");
  const std::atomic<bool> cancel = true;
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const Failure failure = failure_of([&] { read_cloud(file.path(), in_box(kCorner), task); });
  CHECK(failure.status == Status::kCancelled);
}
