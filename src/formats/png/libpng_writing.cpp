// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <new>
#include <vector>

#include "base/error.h"
#include "formats/png/grey_file.h"
#include "formats/png/libpng_session.h"
#include "formats/png/pictures.h"

namespace jalon {

namespace png {

namespace {

// Rows of all kinds of pictures; filters are chosen here, not by libpng's guess, whose time grows with their number.
struct Picture {
  uint32_t width = 0, height = 0;
  int bits = 8, colour_type = PNG_COLOR_TYPE_GRAY;
  int filter = PNG_FILTER_NONE;
  bool is_zero_empty = false;  ///< grey value 0 is transparent
  std::vector<png_color> palette{};
  std::string keyword{}, text{};
};

void write_bytes(png_structp png, png_bytep bytes, size_t count) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  call_back(png, session,
            [&] { session.out->append(reinterpret_cast<const char*>(bytes), count); });
}
void flush_nothing(png_structp) {}

// No destructor may stand between here and guarded(): png_text refers to the picture's own strings.
void write_header(Session& session) {
  const auto& picture = *static_cast<const Picture*>(session.picture);
  png_set_write_fn(session.png, &session, write_bytes, flush_nothing);
  png_set_IHDR(session.png, session.info, picture.width, picture.height, picture.bits,
               picture.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(session.png, PNG_FILTER_TYPE_BASE, picture.filter);
  if (!picture.palette.empty())
    png_set_PLTE(session.png, session.info, picture.palette.data(),
                 static_cast<int>(picture.palette.size()));
  png_color_16 empty = {};
  if (picture.is_zero_empty) png_set_tRNS(session.png, session.info, nullptr, 0, &empty);
  png_text text = {};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = const_cast<char*>(picture.keyword.c_str());
  text.text = const_cast<char*>(picture.text.c_str());
  text.text_length = picture.text.size();
  if (!picture.text.empty()) png_set_text(session.png, session.info, &text, 1);
  png_write_info(session.png, session.info);
}

/// row_of(y): the bytes of a row as PNG has them.
std::string file_of(const Picture& picture, Task& task,
                    const std::function<const uint8_t*(uint32_t)>& row_of) {
  std::string out;
  struct Writing {
    Session session;
    ~Writing() { png_destroy_write_struct(&session.png, &session.info); }
  } writing;
  Session& s = writing.session;
  s.out = &out;
  s.picture = &picture;
  s.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &s, give_up, keep_quiet);
  if (s.png == nullptr) throw std::bad_alloc();
  s.info = png_create_info_struct(s.png);
  if (s.info == nullptr) throw std::bad_alloc();
  const auto run = [&](void (*step)(Session&)) {
    if (guarded(s, step)) return;
    throw_own(s);
    fail(Status::kInternal, "libpng: %.150s", s.message);
  };
  run(write_header);
  for (uint32_t y = 0; y < picture.height; ++y) {
    task.checkpoint(static_cast<double>(y) / picture.height);
    s.row = const_cast<uint8_t*>(row_of(y));
    run([](Session& session) { png_write_row(session.png, session.row); });
  }
  run([](Session& session) { png_write_end(session.png, nullptr); });
  return out;
}

}  // namespace

std::string grey_png(const GreyImage& image, const char* keyword, const std::string& text,
                     Task& task) {
  Picture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.bits = image.bits;
  picture.filter = PNG_ALL_FILTERS;
  picture.is_zero_empty = true;
  picture.keyword = keyword;
  picture.text = text;
  const size_t sample = image.bits == 16 ? 2 : 1;
  std::vector<uint8_t> row(sample * image.width);
  return file_of(picture, task, [&](uint32_t y) {
    const uint16_t* from = image.pixels.data() + size_t{y} * image.width;
    for (size_t c = 0; c < image.width; ++c) {
      if (sample == 2) row[2 * c] = static_cast<uint8_t>(from[c] >> 8);
      row[sample * c + sample - 1] = static_cast<uint8_t>(from[c] & 0xff);
    }
    return row.data();
  });
}

}  // namespace png

std::string png_of(const IndexedImage& image) {
  Task task;
  png::Picture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.colour_type = PNG_COLOR_TYPE_PALETTE;
  for (const Rgb& c : image.palette) picture.palette.push_back({c.red, c.green, c.blue});
  picture.keyword = "Description";
  picture.text = image.description;
  return png::file_of(picture, task,
                      [&](uint32_t y) { return image.pixels.data() + size_t{y} * image.width; });
}

std::string png_of(const RgbaImage& image, Task& task) {
  constexpr size_t kSamples = 4;
  png::Picture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.colour_type = PNG_COLOR_TYPE_RGB_ALPHA;
  picture.filter = PNG_FILTER_SUB;  // natural pictures shrink by it
  return png::file_of(picture, task, [&](uint32_t y) {
    return image.pixels.data() + kSamples * image.width * size_t{y};
  });
}

}  // namespace jalon
