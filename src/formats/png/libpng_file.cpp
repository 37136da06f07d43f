// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "formats/png/grey_file.h"
#include "formats/png/libpng_session.h"

namespace jalon::png {

bool has_libpng() { return true; }
void require_libpng(const std::string&) {}

namespace {

constexpr int kSamplesWithAlpha = 2;

void read_bytes(png_structp png, png_bytep out, size_t bytes) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  call_back(png, session, [&] {
    session.source->read(session.offset, out, bytes);
    session.offset += bytes;
  });
}

}  // namespace

struct GreyReader::State {
  explicit State(const ByteSource& source) {
    session.source = &source;
    session.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &session, give_up, keep_quiet);
    if (session.png == nullptr) throw std::bad_alloc();
    session.info = png_create_info_struct(session.png);
    if (session.info == nullptr) {
      png_destroy_read_struct(&session.png, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~State() { png_destroy_read_struct(&session.png, &session.info, nullptr); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void run(void (*step)(Session&)) {
    if (guarded(session, step)) return;
    throw_own(session);
    session.source->refuse(session.offset, "%.150s", session.message);
  }

  Session session;
  std::vector<png_byte> bytes;  ///< of a row
  bool has_alpha = false, is_wide = false;
  int32_t empty = 0;  ///< this grey value is no return
};

GreyReader::GreyReader(const ByteSource& source, const char* keyword)
    : state_(std::make_unique<State>(source)) {
  Session& s = state_->session;
  state_->run([](Session& session) {
    png_set_read_fn(session.png, &session, read_bytes);
    png_read_info(session.png, session.info);
  });
  width_ = png_get_image_width(s.png, s.info);
  height_ = png_get_image_height(s.png, s.info);
  const auto colours = png_get_color_type(s.png, s.info);
  if (colours != PNG_COLOR_TYPE_GRAY && colours != PNG_COLOR_TYPE_GRAY_ALPHA)
    fail(Status::kUnsupported, "%.400s: a picture in colours; a depth image has grey values",
         source.path().c_str());
  if (png_get_interlace_type(s.png, s.info) != PNG_INTERLACE_NONE)
    fail(Status::kUnsupported, "%.400s: an interlaced picture; write it anew without",
         source.path().c_str());
  if (uint64_t{width_} * height_ > kMostPixels)
    fail(Status::kLimit, "%.400s: %u x %u pixels; a depth image has 2^28 at most",
         source.path().c_str(), width_, height_);
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(s.png, s.info, &texts, &count);
  for (int k = 0; k < count; ++k)
    if (std::string_view(texts[k].key) == keyword && texts[k].text != nullptr)
      text_ = texts[k].text;
  png_color_16p transparent = nullptr;
  if (png_get_tRNS(s.png, s.info, nullptr, nullptr, &transparent) != 0 && transparent != nullptr)
    state_->empty = transparent->gray;
  state_->has_alpha = colours == PNG_COLOR_TYPE_GRAY_ALPHA;
  state_->is_wide = png_get_bit_depth(s.png, s.info) == 16;
  state_->run([](Session& session) {
    png_set_packing(session.png);  // 1, 2 and 4 bits: a byte each, as they are
    png_read_update_info(session.png, session.info);
  });
  state_->bytes.resize(png_get_rowbytes(s.png, s.info));
  s.row = state_->bytes.data();
  row_.resize(width_);
}

GreyReader::~GreyReader() = default;

const std::vector<int32_t>& GreyReader::next_row() {
  state_->run([](Session& session) { png_read_row(session.png, session.row, nullptr); });
  const size_t sample = state_->is_wide ? 2 : 1;
  const size_t step = sample * (state_->has_alpha ? kSamplesWithAlpha : 1);
  const auto value = [&](size_t at) -> int32_t {
    const png_byte* p = state_->bytes.data() + at;
    return state_->is_wide ? p[0] << 8 | p[1] : p[0];
  };
  for (size_t c = 0; c < width_; ++c) {
    const int32_t grey = value(c * step);
    const bool is_empty = state_->has_alpha ? value(c * step + sample) == 0 : grey == state_->empty;
    row_[c] = is_empty ? -1 : grey;
  }
  return row_;
}

void GreyReader::finish() {
  state_->run([](Session& session) { png_read_end(session.png, nullptr); });
}

}  // namespace jalon::png
