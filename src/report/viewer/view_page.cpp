// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/viewer/view_page.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/json_writer.h"
#include "report/sheet/svg_parts.h"
#include "report/viewer/packing.h"
#include "report/viewer/script.h"

namespace jalon {

namespace {

constexpr const char* kStyleOfViewer =
    "#view-box{position:relative;height:36rem;border:1px solid #bbb}"
    "#view-box canvas{position:absolute;left:0;top:0;width:100%;height:100%}"
    "#view-gl{touch-action:none;cursor:grab}#view-gl:focus{outline:2px solid #2c728e}"
    "#view-over{pointer-events:none}"
    "#view-bar{display:flex;flex-wrap:wrap;gap:.4rem "
    ".9rem;align-items:center;font-size:.85rem;margin:.4rem 0}"
    "#view-bar label[hidden]{display:none}#view-bar "
    "input[type=range]{width:8rem;vertical-align:middle}"
    "#view-told{min-height:2.6em}@media print{.view{display:none}}";

std::string bytes_of_hex(const char* text) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string out;
  for (; *text != '\0'; text += 2) out += static_cast<char>(digit(text[0]) * 16 + digit(text[1]));
  return out;
}

void write_vector(JsonWriter& json, const Vec3& v, double digits = 1e4) {
  for (int k = 0; k < 3; ++k) json.value(std::round(v[k] * digits) / digits);
}

void write_channel(JsonWriter& json, const ViewChannel& channel, double step, bool is_plain) {
  static constexpr const char* kKinds[] = {"label", "scale", "rgb"};
  json.begin_object().name("kind").value(kKinds[static_cast<size_t>(channel.kind)]);
  json.name("name").value(channel.name).name("unit").value(channel.unit);
  json.name("low").value(channel.low).name("high").value(channel.high).name("step").value(step);
  json.name("plain").value(is_plain);
  json.name("colours").begin_array();
  for (const Rgb& colour : channel.colours) json.value(hex_of(colour));
  json.end_array().name("none").begin_array();
  for (const auto& none : channel.none)
    json.begin_array().value(hex_of(none.colour)).value(none.name).end_array();
  json.end_array().end_object();
}

// The pose maps steps from the low corner, times the step, to the scene: by columns, as WebGL has matrices.
void write_cloud(JsonWriter& json, const ViewCloud& view, const PackedCloud& packed,
                 const Vec3& origin) {
  const auto& m = view.pose.m;
  const Vec3 corner = view.pose.point(packed.low) - origin;
  json.begin_object().name("name").value(view.name).name("n").value(packed.points);
  json.name("bytes").value(packed.bytes.size());
  json.name("step").value(packed.step_m).name("spacing").value(packed.spacing_m);
  json.name("colour").value(hex_of(view.colour)).name("hidden").value(view.is_hidden);
  json.name("size").begin_array();
  write_vector(json, packed.size);
  json.end_array().name("pose").begin_array();
  for (size_t column = 0; column < 3; ++column) {
    for (size_t row = 0; row < 3; ++row) json.value(m[4 * row + column]);
    json.value(0);
  }
  write_vector(json, corner, 1e6);
  json.value(1).end_array().name("channels").begin_array();
  for (size_t c = 0; c < view.channels.size(); ++c)
    write_channel(json, view.channels[c], packed.channel_steps[c], packed.channel_is_plain[c]);
  json.end_array().end_object();
}

void write_part(JsonWriter& json, const ViewPart& part, const Vec3& origin) {
  json.begin_object().name("tag").value(part.tag).name("text").value(part.text);
  json.name("colour").value(hex_of(part.colour));
  json.name("kind").value(part.is_opening ? "opening" : "face").name("rings").begin_array();
  for (const auto& ring : part.rings) {
    json.begin_array();
    for (const Vec3& p : ring) write_vector(json, p - origin);
    json.end_array();
  }
  json.end_array().end_object();
}

// "<" would end the script that holds the text.
std::string without_tags(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json)
    if (c == '<') out += "\\u003c";
    else out += c;
  return out;
}

std::string scene_json(const ViewScene& scene, const std::vector<PackedCloud>& packed,
                       const Vec3& origin) {
  JsonWriter json;
  json.begin_object().name("origin").begin_array();
  write_vector(json, origin);
  json.end_array().name("axes").begin_array();
  for (const Vec3& axis : {scene.along, scene.towards, Vec3{0, 0, 1}}) {
    json.begin_array();
    write_vector(json, axis, 1e9);
    json.end_array();
  }
  json.end_array();
  if (!scene.focus.empty()) {
    json.name("focus").begin_array();
    write_vector(json, scene.focus.min - origin);
    write_vector(json, scene.focus.max - origin);
    json.end_array();
  }
  json.name("labels").begin_array();
  for (const std::string& label : scene.labels) json.value(label);
  json.end_array().name("clouds").begin_array();
  for (size_t i = 0; i < packed.size(); ++i) write_cloud(json, scene.clouds[i], packed[i], origin);
  json.end_array().name("parts").begin_array();
  for (const ViewPart& part : scene.parts) write_part(json, part, origin);
  json.end_array().end_object();
  return without_tags(json.take());
}

// Shares of the points that all clouds may have, by their sizes; none goes empty.
size_t share_of(const ViewScene& scene, const ViewCloud& view, int64_t most_points) {
  uint64_t all = 0;
  for (const ViewCloud& cloud : scene.clouds) all += cloud.cloud->size();
  const double share = static_cast<double>(view.cloud->size()) / static_cast<double>(all);
  return std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(most_points)));
}

}  // namespace

std::string content_policy() {
  return "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-" +
         base64_of(bytes_of_hex(kViewerScriptSha256)) + "'";
}

const char* viewer_style() { return kStyleOfViewer; }

void add_viewer(Page& page, const ViewScene& scene, int64_t most_points, Task& task) {
  uint64_t points = 0;
  for (const ViewCloud& cloud : scene.clouds) points += cloud.cloud->size();
  if (most_points == 0 || points == 0) return;
  std::vector<PackedCloud> packed;
  uint64_t shown = 0;
  for (const ViewCloud& view : scene.clouds) {
    packed.push_back(pack_cloud(view, share_of(scene, view, most_points), task));
    shown += packed.back().points;
  }
  Vec3 origin;  // whole metres, so that places read off are those of the data
  const Vec3 first = scene.clouds[0].pose.point(packed[0].low);
  for (int k = 0; k < 3; ++k) origin[k] = std::floor(first[k]);
  auto& html = page.html();
  html.open("section", {{"class", "view"}}).element("h2", {}, "In three dimensions");
  html.open("div", {{"id", "view-box"}});
  html.element("canvas",
               {{"id", "view-gl"},
                {"tabindex", 0},
                {"aria-label", "View in three dimensions; the keys stand below it"}},
               "");
  html.element("canvas", {{"id", "view-over"}, {"aria-hidden", "true"}}, "").close();
  html.element("div", {{"id", "view-bar"}}, "");
  html.element("p", {{"id", "view-told"}, {"class", "note"}, {"aria-live", "polite"}}, "");
  html.element("noscript", {}, "The view needs JavaScript; the pictures show the same.");
  if (shown < points)
    page.note(grouped(shown) + " of " + grouped(points) +
              " points, evenly taken. A link to this page keeps the view.");
  // As raw text: what stands between the tags is hashed to the byte.
  html.raw("<script type=\"application/json\" id=\"view-scene\">" +
           scene_json(scene, packed, origin) + "</script>\n");
  for (size_t i = 0; i < packed.size(); ++i)
    html.raw("<script type=\"text/plain\" id=\"view-data-" + std::to_string(i) + "\">" +
             text_of_bytes(packed[i].bytes) + "</script>\n");
  html.raw("<script>" + std::string(kViewerScript) + "</script>\n").close();
}

}  // namespace jalon
