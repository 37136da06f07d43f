// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "formats/codecs/codecs.h"

namespace jalon {

bool has_codecs() { return false; }
void require_codecs(const std::string& path, const char* format) {
  fail(Status::kUnsupported,
       "%.400s: %s needs the component JALON_WITH_RUST_FORMATS, which this library was built "
       "without: install cargo (Debian 12: apt install cargo-web) and build it again",
       path.c_str(), format);
}

// Never called: require_codecs() comes before.
int32_t jc_laz_layout(const uint8_t*, uint64_t, JcLazLayout*, JcMessage) { return 1; }
int32_t jc_laz_chunks(const uint8_t*, uint64_t, int32_t, uint64_t*, uint64_t*, uint64_t,
                      JcMessage) {
  return 1;
}
int32_t jc_laz_check(const uint8_t*, uint64_t, const uint8_t*, uint64_t, uint64_t, JcMessage) {
  return 1;
}
int32_t jc_laz_decode(const uint8_t*, uint64_t, const uint8_t*, uint64_t, uint8_t*, uint64_t,
                      JcMessage) {
  return 1;
}
int32_t jc_laz_decode_within(const uint8_t*, uint64_t, const uint8_t*, uint64_t, const int32_t*,
                             uint8_t*, uint64_t, uint64_t*, JcMessage) {
  return 1;
}
void jc_bytes_free(JcBytes) {}
int32_t jc_laz_record(uint8_t, uint16_t, uint32_t, JcBytes*, JcMessage) { return 1; }
int32_t jc_laz_encode(const uint8_t*, uint64_t, const uint8_t*, uint64_t, JcBytes*, JcMessage) {
  return 1;
}
int32_t jc_laz_table(const uint8_t*, uint64_t, const uint64_t*, const uint64_t*, uint64_t, JcBytes*,
                     JcMessage) {
  return 1;
}
int32_t jc_e57_open(JcSource, JcE57**, uint64_t*, JcMessage) { return 1; }
void jc_e57_close(JcE57*) {}
int32_t jc_e57_crs(JcE57*, const char**, JcMessage) { return 1; }
int32_t jc_e57_scan(JcE57*, uint64_t, JcScan*, JcMessage) { return 1; }
int32_t jc_e57_column(JcE57*, uint64_t, uint64_t, JcColumn*, JcPacking*, JcMessage) { return 1; }
int32_t jc_e57_create(JcSink, const char*, const char*, JcE57Writing**, JcMessage) { return 1; }
int32_t jc_e57_begin(JcE57Writing*, const char*, const char*, const double*, const JcColumn*,
                     uint64_t, JcMessage) {
  return 1;
}
int32_t jc_e57_add(JcE57Writing*, const double*, uint64_t, JcMessage) { return 1; }
int32_t jc_e57_end(JcE57Writing*, JcMessage) { return 1; }
int32_t jc_e57_finish(JcE57Writing*, JcMessage) { return 1; }
void jc_e57_discard(JcE57Writing*) {}

}  // namespace jalon
