// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/comparing/extras.h"

#include <cmath>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

// volumes.csv has a row a cell; of two closed models there are none.
Json write_volumes(const Console& console, const PathOf& path_of, const Side& reference,
                   const Side& compared, const Settings& settings) {
  const Params options = make_params("volume");
  settings.apply(options.get());
  Fields summary, cells;
  if (reference.model != nullptr)
    must(jalon_model_volume(reference.model.get(), compared.model.get(), options.get(),
                            console.task(), Out(summary), Out(cells)));
  else
    must(jalon_cloud_volume(reference.cloud.get(), compared.cloud.get(), options.get(),
                            console.task(), Out(summary), Out(cells)));
  write_text_file(path_of("volumes.csv"), Table(std::move(cells)).csv());
  Json out{{"parameters", json_of(options.get())}};
  out.update(Table(std::move(summary)).object(0));
  return out;
}

// A picture a station; stations without points have none.
Json write_depth_maps(const Console& console, const PathOf& path_of, const Cloud& cloud,
                      const std::string& side, const Params& options) {
  uint64_t stations = 0;
  must(jalon_cloud_station_count(cloud.get(), &stations));
  Json out = Json::array();
  for (uint64_t i = 0; i < stations; ++i) {
    uint64_t points = 0;
    int32_t has_pose = 0;
    must(jalon_cloud_station(cloud.get(), i, nullptr, &has_pose, nullptr, nullptr, &points));
    if (points == 0 || has_pose == 0) continue;
    for (const char* end : {".png", ".tif"}) {
      const std::string name = "depth_" + side + "_" + std::to_string(i + 1) + end;
      must(jalon_cloud_write_depth_map(cloud.get(), i, path_of(name).c_str(), options.get(),
                                       console.task()));
      out.push_back(name);
    }
  }
  return out;
}

// How many hidden points the third epoch tells of: the codes of the column "recovered".
Json recovered_of(const Comparison& comparison, uint64_t hidden) {
  Fields points;
  must(jalon_comparison_points(comparison.get(), Out(points)));
  uint64_t count = 0, unchanged = 0, changed = 0;
  const uint8_t* recovered = values<uint8_t>(points, "recovered", &count);
  for (uint64_t i = 0; i < count; ++i) {
    unchanged += recovered[i] == JALON_PROBABLY_UNCHANGED ? 1 : 0;
    changed += recovered[i] == JALON_CHANGED_MEANWHILE ? 1 : 0;
  }
  return {{"hidden", hidden}, {"probably_unchanged", unchanged}, {"changed_meanwhile", changed}};
}

}  // namespace

void Extras::add_to(Command& command) {
  command.flag("--volumes", with_volumes_,
               "Volumes between both, by cells across a direction: volumes.csv, and cut, fill and "
               "net in the result");
  volume_settings_.add_to(command, "volume-");
  command.flag("--closest", with_closest_,
               "The reference points that are nearest to a compared one, as closest.las and .ply");
  command.flag(
      "--depth-maps", with_depth_maps_,
      "What the stations of both scans saw, a picture each and its ranges in metres as TIFF: "
      "depth_reference_1.png, depth_reference_1.tif ...");
  depth_settings_.add_to(command, "depth-");
  command
      .option("--third", third_.path,
              "Scan of the epoch beyond the reference: tells which points that were hidden from "
              "the reference did probably not change")
      .type_name("SCAN");
  command
      .option("--third-tolerance", third_tolerance_m_,
              "Distance (m) from the third epoch up to which they did not")
      .positive()
      .shows_default();
}

std::string Extras::tables() {
  return "Parameters of --volume-set:\n" + describe(make_params("volume").get()) +
         "\nParameters of --depth-set:\n" + describe(make_params("visibility").get()) + "\n";
}

void Extras::check(bool reference_is_model, bool compared_is_model,
                   const std::string& method) const {
  const bool has_model = reference_is_model || compared_is_model;
  if (with_volumes_ && reference_is_model != compared_is_model)
    throw Failure{JALON_ERROR_UNSUPPORTED, "--volumes are of two scans or of two models"};
  if (with_closest_ && (reference_is_model || method != "distance"))
    throw Failure{JALON_ERROR_UNSUPPORTED,
                  "--closest is for method distance with a scan as the reference"};
  if (with_depth_maps_ && has_model)
    throw Failure{JALON_ERROR_UNSUPPORTED, "--depth-maps are of scans, not of a model"};
  if (!third_.path.empty() && (has_model || method != "distance"))
    throw Failure{JALON_ERROR_UNSUPPORTED, "--third is for method distance with two scans"};
  for (const auto& [settings, name] :
       {std::pair{&volume_settings_, "volume"}, std::pair{&depth_settings_, "visibility"}})
    settings->apply(make_params(name).get());
}

Json Extras::use_third_epoch(Console& console, const jalon_comparer* worker, const Cloud& compared,
                             Direction& forward) const {
  if (third_.path.empty()) return nullptr;
  const uint64_t hidden = forward.summary->count("hidden", 0);
  const Cloud third = third_.read(console);
  Comparison across, made;
  must(jalon_comparer_run(worker, third.get(), compared.get(), console.task(), Out(across)));
  must(jalon_comparison_third_epoch(forward.comparison.get(), across.get(), third_tolerance_m_,
                                    console.task(), Out(made)));
  forward = Direction::of(std::move(made));
  Json out{{"file", third_.path}, {"tolerance_m", third_tolerance_m_}};
  out.update(recovered_of(forward.comparison, hidden));
  return out;
}

void Extras::write(const Console& console, const PathOf& path_of, const Side& reference,
                   const Side& compared, const Direction& forward, Json& result) const {
  if (with_volumes_)
    result["volumes"] = write_volumes(console, path_of, reference, compared, volume_settings_);
  if (with_closest_) {
    Cloud closest;
    must(jalon_comparison_closest_points(forward.comparison.get(), reference.cloud.get(),
                                         console.task(), Out(closest)));
    result["closest_points"] = count_of(closest);
    Beside beside(console);
    write_both(beside, path_of, std::move(closest), "closest");
    beside.wait();
  }
  if (with_depth_maps_) {
    const Params options = make_params("visibility");
    depth_settings_.apply(options.get());
    Json names = write_depth_maps(console, path_of, reference.cloud, "reference", options);
    for (Json& name : write_depth_maps(console, path_of, compared.cloud, "compared", options))
      names.push_back(std::move(name));
    if (names.empty())
      throw Failure{
          JALON_ERROR_INVALID_ARGUMENT,
          "--depth-maps: neither scan tells where its scanner stood; --reference-station and "
          "--compared-station give the places"};
    result["depth_maps"] = std::move(names);
  }
  Fields parts;
  must(jalon_comparison_parts(forward.comparison.get(), Out(parts)));
  const Table table(std::move(parts));
  if (table.rows() == 0) return;
  write_text_file(path_of("parts.csv"), table.csv());
  result["parts"] = table.list();
}

void Extras::say(const Console& console, const Json& result, const Lengths& lengths) const {
  if (result.contains("volumes")) {
    const Json& v = result["volumes"];
    std::string line = "volumes:";
    for (const char* name : {"cut", "fill", "net", "sigma"})
      if (v.contains(name) && v[name].is_number())
        line += std::string(line.back() == ':' ? " " : ", ") + name + " " +
                fixed(v[name].get<double>(), 3);
    console.say(line + (lengths.is_known() ? " m3" : " cubic units"));
  }
  if (result.contains("closest_points"))
    console.say("closest points: " + grouped(result["closest_points"].get<uint64_t>()) +
                " of the reference");
  if (result.contains("depth_maps"))
    console.say("depth maps: " + std::to_string(result["depth_maps"].size()));
  if (result.contains("third_epoch")) {
    const Json& third = result["third_epoch"];
    console.say("of " + grouped(third["hidden"].get<uint64_t>()) + " hidden points " +
                grouped(third["probably_unchanged"].get<uint64_t>()) +
                " probably did not change, " + grouped(third["changed_meanwhile"].get<uint64_t>()) +
                " did");
  }
}

}  // namespace jalon::cli
