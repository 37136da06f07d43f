// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/text_number.h"
#include "formats/files/atomic_file.h"
#include "formats/files/normal_columns.h"
#include "formats/files/number_text.h"
#include "formats/files/utf8.h"
#include "formats/text/layout.h"
#include "formats/text/text.h"

namespace jalon {

namespace {

constexpr size_t kGrain = size_t{1} << 13;  // points a chunk
constexpr size_t kBatch = 32 * kGrain;      // points formatted in parallel, then written in one go

// A name as one cell that no table reader or spreadsheet takes for anything else.
std::string safe_cell(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain = static_cast<unsigned char>(c) > 0x20 && c != 0x7f && c != ',' && c != ';' &&
                       c != '"' && c != '\'' && c != '#' && c != '/';
    out += plain ? c : '_';
  }
  if (out.empty() || out == "-" || out == "_" || (out[0] >= '0' && out[0] <= '9') ||
      out.find_first_of("=+-@%.") == 0)
    out.insert(out.begin(), '_');
  return out;
}

// A reader passes over a header that names a coordinate twice, and "X" is one of its names of x: told
// apart are the names that readers make of ours.
std::string unique_cell(const std::string& cell, UniqueNames& unique) {
  const std::string read = usual_name(cell), given = unique.add(read);
  return given == read ? cell : given;
}

std::vector<std::string> column_names(const FieldTable& fields) {
  std::vector<std::string> names{"x", "y", "z"};
  UniqueNames unique;
  reserve_point_names(fields, unique);
  for (const ColumnPtr& column : fields) {
    const FieldInfo& field = column->info();
    for (uint32_t c = 0; c < field.components; ++c) {
      const std::string name = field.components == 1 ? field.name : numbered(field.name, c);
      names.push_back(is_normal(field) ? kNormalColumns[c] : unique_cell(safe_cell(name), unique));
    }
  }
  return names;
}

void append_point(std::string& out, const Cloud& cloud, size_t i, char separator, int decimals) {
  const double* p = cloud.xyz().data() + 3 * i;
  for (size_t k = 0; k < 3; ++k) {
    if (k != 0) out += separator;
    if (decimals < 0) append_number(out, p[k]);
    else out += text_of(p[k], decimals);
  }
  for (const ColumnPtr& column : cloud.fields) append_item(out, *column, i, separator);
  out += '\n';
}

/// Lines under a head, which the first piece settles.
class TextSink : public CloudSink {
 public:
  TextSink(std::string path, bool comma, int decimals)
      : path_(std::move(path)), comma_(comma), decimals_(decimals) {}

  bool put(const Cloud& piece, Task& task) override {
    const std::string head = head_of(piece);
    if (file_ && head != head_) return false;
    if (!file_) {
      file_.emplace(path_);
      file_->write(head_ = head);
    }
    write_in_batches(piece.size(), kBatch, kGrain, *file_, task,
                     [&](size_t begin, size_t end, std::string& out) {
                       for (size_t i = begin; i < end; ++i)
                         append_point(out, piece, i, comma_ ? ',' : ' ', decimals_);
                     });
    return true;
  }

  void finish(Task& task) override {
    task.checkpoint(1);
    file_->commit();
  }

 private:
  std::string head_of(const Cloud& cloud) const {
    std::string head;
    const std::string& crs = cloud.crs.str();
    if (!comma_ && !crs.empty() && crs.find_first_of("\r\n") == std::string::npos)
      head = "# crs: " + crs + "\n";
    if (!comma_) head += "#";
    bool first_name = comma_;
    for (const std::string& name : column_names(cloud.fields)) {
      if (!first_name) head += comma_ ? ',' : ' ';
      first_name = false;
      head += name;
    }
    return head + "\n";
  }

  const std::string path_;
  const bool comma_;
  const int decimals_;
  std::optional<AtomicFile> file_;
  std::string head_;
};

void write_lines(const Cloud& cloud, const std::string& path, bool comma, int decimals,
                 Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing text");
  TextSink sink(path, comma, decimals);
  sink.put(cloud, task);
  sink.finish(task);
}

}  // namespace

void write_text(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Task& task) {
  write_lines(cloud, path, false, settings.decimals, task);
}

void write_csv(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  write_lines(cloud, path, true, settings.decimals, task);
}

std::unique_ptr<CloudSink> text_sink(const std::string& path, const WriteSettings& settings,
                                     uint64_t) {
  return std::make_unique<TextSink>(path, false, settings.decimals);
}

std::unique_ptr<CloudSink> csv_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t) {
  return std::make_unique<TextSink>(path, true, settings.decimals);
}

}  // namespace jalon
