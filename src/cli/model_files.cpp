// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/model_files.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/methods.h"
#include "cli/output_check.h"
#include "cli/outputs/beside.h"
#include "cli/table.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

// PLY is left out: it holds triangles alone, and STL does that already.
constexpr const char* kExtensions[] = {"obj", "dxf", "city.json", "geojson", "gpkg", "stl"};

// Is the extension one of a format of models that the library writes?
bool is_written(const std::string& extension) {
  return written_extensions("model").find(" " + extension + " ") != std::string::npos;
}

Json count_classes(jalon_model* model) {
  Json classes = Json::object();
  uint64_t parts = 0;
  must(jalon_model_part_count(model, &parts));
  for (uint64_t i = 0; i < parts; ++i) {
    const char* name = nullptr;
    must(jalon_model_part(model, i, nullptr, &name, nullptr));
    classes[name] = classes.value(name, uint64_t{0}) + 1;
  }
  return classes;
}

uint64_t facades_of(jalon_model* model) {
  return count_classes(model).value("facade", uint64_t{0});
}

void draw(const Console& console, jalon_segmentation* segmentation, jalon_model* model,
          jalon_params* options, uint64_t facade, const std::string& path) {
  must(jalon_params_set_int64(options, "facade", static_cast<int64_t>(facade)));
  must(jalon_report_write_elevation(segmentation, model, path.c_str(), options, console.task()));
}

// What differs from the defaults, and the three numbers that every scanner's specification has.
Json told(jalon_params* params) {
  const Json all = json_of(params), defaults = json_of(make_params("precision").get());
  Json out = Json::object();
  for (const auto& [name, value] : all.items())
    if (name.starts_with("sigma_range") || name.starts_with("sigma_horizontal") ||
        name.starts_with("sigma_vertical") || value != defaults[name])
      out[name] = value;
  return out;
}

// What "dxf_images" takes.
std::string png_list(const std::vector<std::string>& names, const OutputFolder& folder) {
  std::string list;
  for (const std::string& name : names)
    if (name.ends_with(".png")) list += (list.empty() ? "" : "|") + folder.unlisted_path(name);
  return list;
}

// As used; empty where it has none (labels, picks).
Json parameters_of(jalon_segmentation* segmentation) {
  const char* text = nullptr;
  must(jalon_segmentation_parameters(segmentation, &text));
  return Json::parse(text, nullptr, false);
}

void write_relations(const Console& console, jalon_model* model, const std::string& of,
                     const std::string& path) {
  const Params options = make_params("relations");
  must(jalon_params_set_string(options.get(), "elements", of.c_str()));
  Fields fields;
  must(jalon_model_relations(model, options.get(), console.task(), Out(fields)));
  write_text_file(path, Table(std::move(fields)).csv());
}

// An orthoimage to be written.
struct OrthoimageFile {
  std::string stem, extension;
  uint64_t facade = 0;    // 0: the only one
  std::string why_not{};  // it was left out
};

// Each holds its facade's points and pixels while it is made.
constexpr size_t kImagesAtOnce = 4;

bool is_left_out(jalon_status status) {
  return status == JALON_ERROR_DEGENERATE || status == JALON_ERROR_INSUFFICIENT_DATA ||
         status == JALON_ERROR_UNSUPPORTED;  // a library without libpng
}

}  // namespace

Segmenter make_segmenter(const std::string& method, Params& params) {
  Segmenter made;
  must_know(jalon_segmenter_create(method.c_str(), Out(made)));
  must(jalon_segmenter_params(made.get(), Out(params)));
  return made;
}

Modeller make_modeller(const std::string& method, Params& params) {
  Modeller made;
  must_know(jalon_modeller_create(method.c_str(), Out(made)));
  must(jalon_modeller_params(made.get(), Out(params)));
  return made;
}

std::string segmenter_tables(const std::string& option) {
  return method_tables<Segmenter>("Parameters of " + option + " with planes by ",
                                  jalon_segmenter_methods, jalon_segmenter_create,
                                  jalon_segmenter_params);
}

std::string modeller_tables(const std::string& option) {
  return method_tables<Modeller>("Parameters of " + option + " with the model by ",
                                 jalon_modeller_methods, jalon_modeller_create,
                                 jalon_modeller_params);
}

void Orthoimages::add_to(Command& command) {
  command
      .option("--orthoimage", kind,
              "Orthoimage of each facade: png with a world file, linked into model.dxf; tif: "
              "GeoTIFF; both; none")
      .among({"png", "tif", "both", "none"})
      .shows_default()
      .type_name("KIND");
  settings.add_to(command, "orthoimage-");
}

void Orthoimages::check() const { settings.apply(make_params("orthoimage").get()); }

std::vector<std::string> Orthoimages::write(const Console& console,
                                            jalon_segmentation* segmentation, jalon_model* model,
                                            uint64_t facades, OutputFolder& folder) const {
  std::vector<OrthoimageFile> files;
  const Params options = make_params("orthoimage");
  settings.apply(options.get());
  int64_t only = 0;
  must(jalon_params_get_int64(options.get(), "facade", &only));
  const bool each = only == 0 && facades > 1;
  for (const char* extension : {".png", ".tif"})
    if (kind == "both" || extension == "." + kind)
      for (uint64_t k = each ? 1 : 0; k <= (each ? facades : 0); ++k)
        files.push_back({each ? "orthoimage_" + std::to_string(k) : "orthoimage", extension, k});
  // Packing one's pixels is for one thread alone.
  for (size_t begin = 0; begin < files.size(); begin += kImagesAtOnce) {
    Beside beside(console);
    for (size_t i = begin; i < std::min(files.size(), begin + kImagesAtOnce); ++i)
      beside.run([&, i](jalon_task* task) {
        const Params own = make_params("orthoimage");
        settings.apply(own.get());
        if (each)
          must(jalon_params_set_int64(own.get(), "facade", static_cast<int64_t>(files[i].facade)));
        const std::string path = folder.unlisted_path(files[i].stem + files[i].extension);
        const jalon_status status =
            jalon_report_write_orthoimage(segmentation, model, path.c_str(), own.get(), task);
        if (is_left_out(status)) files[i].why_not = jalon_last_error_message();
        else must(status);
      });
    beside.wait();
  }
  std::vector<std::string> names;
  for (const auto& [stem, extension, facade, why_not] : files) {
    if (!why_not.empty()) {
      console.warn(stem + extension + " is left out: " + why_not);
      continue;
    }
    names.push_back(stem + extension);
    if (extension == ".png") names.push_back(stem + ".pgw");
  }
  for (const std::string& name : names) folder.path(name);
  return names;
}

void ModelFiles::add_to(Command& command) {
  drawing.add_to(command, "drawing-");
  scanner.add_to(command, "scanner-");
  orthoimages.add_to(command);
  command
      .option(
          "--relations", relations,
          "Write relations.csv too: how parts, faces or solids lie to each other (9-intersection, "
          "distance, direction)")
      .among({"parts", "faces", "solids"})
      .type_name("OF");
}

void ModelFiles::check() const {
  drawing.apply(make_params("elevation").get());
  scanner.apply(make_params("precision").get());
  orthoimages.check();
}

void ModelFiles::note_scanner(jalon_cloud* cloud, Json& notes) const {
  if (!scanner.is_given()) return;
  const Params params = make_params("precision");
  scanner.apply(params.get());
  uint64_t stations = 0;
  must(jalon_cloud_station_count(cloud, &stations));
  if (stations == 0)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                  "the precision of the scanner needs its place, which the file does not tell: add "
                  "--station X,Y,Z"};
  notes["scanner"] = told(params.get());
}

std::vector<std::string> ModelFiles::write(const Console& console, jalon_segmentation* segmentation,
                                           jalon_model* model, const std::string& source,
                                           OutputFolder& folder) const {
  std::vector<std::string> names;
  const auto images = orthoimages.write(console, segmentation, model, facades_of(model), folder);
  const Params linking = make_params("write");
  must(jalon_params_set_string(linking.get(), "dxf_images", png_list(images, folder).c_str()));
  for (const char* extension : kExtensions) {
    if (!is_written(extension)) continue;
    names.push_back(std::string("model.") + extension);
    must(
        jalon_model_write(model, folder.path(names.back()).c_str(), linking.get(), console.task()));
  }
  names.insert(names.end(), images.begin(), images.end());
  const Params options = make_params("elevation");
  must(jalon_params_set_string(options.get(), "source",
                               std::filesystem::path(source).filename().string().c_str()));
  drawing.apply(options.get());
  int64_t only = 0;
  must(jalon_params_get_int64(options.get(), "facade", &only));
  names.push_back("elevation.svg");
  draw(console, segmentation, model, options.get(), static_cast<uint64_t>(only),
       folder.path(names.back()));
  const uint64_t facades = only == 0 ? facades_of(model) : 0;
  for (uint64_t k = 1; facades > 1 && k <= facades; ++k) {
    names.push_back("elevation_" + std::to_string(k) + ".svg");
    draw(console, segmentation, model, options.get(), k, folder.path(names.back()));
  }
  if (!relations.empty()) {
    names.push_back("relations.csv");
    write_relations(console, model, relations, folder.path(names.back()));
  }
  return names;
}

Json summary_of(jalon_model* model) {
  Fields faces;
  must(jalon_model_faces(model, Out(faces)));
  uint64_t count = 0;
  values<uint32_t>(faces, "part", &count);
  return {{"faces", count}, {"parts", count_classes(model)}};
}

std::string summary_line(const Json& summary) {
  std::string text = std::to_string(summary["faces"].get<uint64_t>()) + " faces";
  const char* separator = "; ";
  for (const auto& [name, count] : summary["parts"].items()) {
    text += separator + std::to_string(count.get<uint64_t>()) + " " + name;
    separator = ", ";
  }
  return text;
}

double used_tolerance_m(jalon_segmentation* segmentation) {
  return parameters_of(segmentation)["distance_tolerance_m"];
}

std::string noise_note(jalon_segmenter* segmenter, jalon_segmentation* segmentation,
                       const Lengths& lengths) {
  const Json used = parameters_of(segmentation);
  if (!used.is_object() || used.value("tolerance_from", "") != "auto") return "";
  Params params;
  must(jalon_segmenter_params(segmenter, Out(params)));
  double set_m = 0;
  must(jalon_params_get_double(params.get(), "distance_tolerance_m", &set_m));
  const double tolerance_m = used["distance_tolerance_m"];
  if (tolerance_m <= set_m) return "";
  const std::string unit = std::string(" ") + lengths.fine();
  return "the surfaces of this scan have a noise of " + lengths.fine(used["sigma_m"], 0) + unit +
         ": planes were found with a tolerance of " + lengths.fine(tolerance_m, 0) + unit +
         " instead of " + lengths.fine(set_m, 0) + "; --tolerance sets it";
}

std::string front_note(jalon_segmentation* segmentation) {
  constexpr double kSure = 0.95;
  constexpr double kWall_m2 = 4;  // as the modeller's smallest wall
  Fields fields;
  must(jalon_segmentation_segments(segmentation, Out(fields)));
  uint64_t count = 0, walls = 0, guessed = 0;
  const auto* source = values<uint8_t>(fields, "front_source", &count);
  const auto* confidence = values<double>(fields, "front_confidence");
  const auto* area = values<double>(fields, "area");
  const auto* label = values<uint32_t>(fields, "label");
  uint64_t weakest = 0;
  for (uint64_t i = 0; i < count; ++i) {
    if (source[i] != JALON_FRONT_EVIDENCE || area[i] < kWall_m2) continue;
    ++walls;
    if (confidence[i] >= kSure) continue;
    if (guessed++ == 0 || confidence[i] < confidence[weakest]) weakest = i;
  }
  if (guessed == 0) return "";
  return "the viewing side of " + std::to_string(guessed) + " of " + std::to_string(walls) +
         " walls is a guess (plane " + std::to_string(label[weakest]) + ": probability " +
         fixed(confidence[weakest], 2) + "); --station X,Y,Z tells it";
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace jalon::cli
