// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "cloud/cloud.h"
#include "formats/formats.h"

namespace jalon::test {

/// A folder of its own, gone with the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "jalon-formats-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  size_t entries() const {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::string path_;
};

inline std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline void spill(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

struct Failure {
  Status status = Status::kOk;
  std::string text;
};
template <class F>
Failure failure_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return {error.status(), error.what()};
  }
  return {};
}

inline Cloud read(const std::string& path, const ReadSettings& settings = {}) {
  Task task;
  return read_cloud(path, settings, task);
}
inline void write(const Cloud& cloud, const std::string& path, const WriteSettings& settings = {}) {
  Task task;
  write_cloud(cloud, path, settings, task);
}
inline Cloud read_as_text(const std::string& text, const std::string& columns = "") {
  const Folder folder;
  spill(folder.file("a.txt"), text);
  ReadSettings settings;
  settings.columns = columns;
  return read(folder.file("a.txt"), settings);
}

/// Path of a shared file, or "" after saying that the test is skipped.
inline std::string shared(const std::string& name) {
  const std::string path = std::string(JALON_SHARED_DATA) + "/" + name;
  if (std::filesystem::exists(path)) return path;
  MESSAGE("skipped: no ", path);
  return "";
}

inline Cloud random_points(size_t n, uint64_t seed, const Vec3& centre = {652000, 6861000, 100}) {
  RandomStream random(seed, 1);
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < 3 * n; ++i)
    xyz[i] = centre[static_cast<int>(i % 3)] + 50 * (random.uniform() - 0.5);
  return make_cloud(std::move(xyz));
}

/// A column of random bits; floats are finite.
inline ColumnPtr random_column(const std::string& name, ElementType type, uint32_t components,
                               size_t n, RandomStream& random) {
  auto column = std::make_shared<Column>(FieldInfo{name, type, components, "", ""}, n);
  visit(type, [&](auto zero) {
    using T = decltype(zero);
    for (T& value : column->values<T>()) {
      if constexpr (std::is_floating_point_v<T>) {
        const double size = std::pow(10.0, static_cast<double>(random.below(9)) - 4);
        value = static_cast<T>(random.normal() * size);
      } else {
        value = static_cast<T>(random.bits());
      }
    }
  });
  return column;
}

inline bool same_values(const Column& a, const Column& b) {
  if (a.count() != b.count() || a.info().components != b.info().components) return false;
  for (size_t i = 0; i < a.count(); ++i)
    for (uint32_t c = 0; c < a.info().components; ++c) {
      const double va = a.number(i, c), vb = b.number(i, c);
      // Texts of float32 read back as doubles that round to the same float32.
      if (va != vb && !(std::isnan(va) && std::isnan(vb)) &&
          static_cast<float>(va) != static_cast<float>(vb))
        return false;
      if (va != vb && !is_floating(a.info().type)) return false;
      if (va != vb && a.info().type == ElementType::kFloat64) return false;
    }
  return true;
}

}  // namespace jalon::test
