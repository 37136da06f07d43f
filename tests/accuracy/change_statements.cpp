// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "change_statements.h"

#include <sstream>

#include "compare/distance/distance.h"
#include "recipe.h"

namespace jalon::test {

namespace {

constexpr size_t kEnoughPoints = 100;  // of a thing, for anything to be told about it
constexpr double kSeenShare = 0.5;     // of them, where the other epoch could see
constexpr double kClearly = 2;         // thresholds

std::vector<uint32_t> faces_of(const Cloud& cloud) {
  const auto faces = cloud.fields.require("face").values<uint32_t>();
  return {faces.begin(), faces.end()};
}

// Does anything of the scene stand between?
bool is_blocked(const Model& model, const Vec3& from, const Vec3& to) {
  constexpr double kBeforeIt = 0.999, kEdge = 1e-12;
  const Vec3 way = to - from;
  for (const auto& t : model.triangles) {
    const Vec3 a = model.vertices[t[0]], u = model.vertices[t[1]] - a, v = model.vertices[t[2]] - a;
    const Vec3 h = cross(way, v);
    const double det = dot(u, h);
    if (std::abs(det) < kEdge) continue;
    const Vec3 s = from - a;
    const double p = dot(s, h) / det;
    if (p < 0 || p > 1) continue;
    const Vec3 q = cross(s, u);
    const double r = dot(way, q) / det, at = dot(v, q) / det;
    if (r >= 0 && p + r <= 1 && at > 0 && at < kBeforeIt) return true;
  }
  return false;
}

// Has the thing enough points in this epoch, where the other could see?
bool was_in_sight(const Cloud& cloud, const std::vector<uint32_t>& objects, uint32_t object,
                  const TriangleScene& other, const std::vector<ScanStation>& stations) {
  constexpr size_t kSample = 40;
  std::vector<size_t> points;
  for (size_t i = 0; i < objects.size(); ++i)
    if (objects[i] == object) points.push_back(i);
  if (points.size() < kEnoughPoints) return false;
  size_t seen = 0;
  for (size_t k = 0; k < kSample; ++k) {
    const Vec3 p = cloud.point(points[k * points.size() / kSample]);
    seen += std::any_of(stations.begin(), stations.end(), [&](const ScanStation& s) {
      return !is_blocked(other.model(), s.pose.translation(), p);
    });
  }
  return static_cast<double>(seen) >= kSeenShare * kSample;
}

size_t count_of(const std::vector<uint32_t>& objects, uint32_t object) {
  return static_cast<size_t>(std::count(objects.begin(), objects.end(), object));
}

struct BothWays {
  Comparison forward, reverse;
};

Comparison detected(const CloudPtr& reference, const CloudPtr& compared, bool has_stations) {
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = has_stations ? DistanceSettings::VisibleFrom::kFound
                                     : DistanceSettings::VisibleFrom::kAnywhere;
  return compare_distance(reference, compared, settings, task);
}

using Counts = std::map<uint32_t, size_t>;

void count_changed(const Epoch& epoch, const std::vector<uint32_t>& points,
                   const std::vector<uint32_t>& objects, Counts& out) {
  for (const uint32_t i : points) out[objects[i]] += epoch.regions.labels[i] != 0 ? 1 : 0;
}

uint32_t most_of(const Counts& count) {
  return std::max_element(count.begin(), count.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// The thing that most of the changed points lie on.
uint32_t object_of(const Change& change, const Diagnosis& found, const KnownEpochs& epochs) {
  Counts count;
  count_changed(found.before, change.object.before, epochs.objects_before, count);
  count_changed(found.after, change.object.after, epochs.objects_after, count);
  return most_of(count);
}

// Of a motion: was it this thing before, and is it after? By all points, for of what was pushed some changed on one
// side.
bool is_one_thing(const Change& change, uint32_t object, const KnownEpochs& epochs) {
  Counts before, after;
  for (const uint32_t i : change.object.before) ++before[epochs.objects_before[i]];
  for (const uint32_t i : change.object.after) ++after[epochs.objects_after[i]];
  return !before.empty() && !after.empty() && most_of(before) == object && most_of(after) == object;
}

const char* name_of(Happened what) {
  constexpr const char* kNames[] = {"came", "went", "moved", "gave way"};
  return kNames[static_cast<size_t>(what)];
}

const TrueChange* change_of(uint32_t object, const KnownEpochs& epochs) {
  for (const TrueChange& c : epochs.changes)
    if (c.object == object) return &c;
  return nullptr;
}

std::string truth_of(uint32_t object, const KnownEpochs& epochs) {
  const TrueChange* truth = change_of(object, epochs);
  return truth != nullptr ? name_of(truth->what) : "nothing";
}

Statement statement_of(const Change& change, const Diagnosis& found, const KnownEpochs& epochs) {
  Statement out;
  out.object = object_of(change, found, epochs);
  out.change_class = change.change_class;
  out.confidence = change.confidence;
  out.features = change.features;
  const TrueChange* truth = change_of(out.object, epochs);
  out.is_changed = truth != nullptr;
  out.is_right = out.is_changed && truth->what == happened(out.change_class);
  out.is_one_thing = out.is_right && (happened(out.change_class) != Happened::kMoved ||
                                      is_one_thing(change, out.object, epochs));
  return out;
}

}  // namespace

KnownEpochs known_epochs(const EpochScenes& scenes, uint64_t seed) {
  KnownEpochs out;
  out.before = scanned(scenes.before, scenes.from_before, 2 * seed, scenes.setting);
  out.after = scanned(scenes.after, scenes.from_after, 2 * seed + 1, scenes.setting);
  out.objects_before = faces_of(*out.before);
  out.objects_after = faces_of(*out.after);
  out.changes = scenes.changes;
  for (const TrueChange& c : out.changes) {
    const bool was =
        c.what == Happened::kCame ||
        was_in_sight(*out.before, out.objects_before, c.object, scenes.after, scenes.from_after);
    const bool is =
        c.what == Happened::kWent ||
        was_in_sight(*out.after, out.objects_after, c.object, scenes.before, scenes.from_before);
    const bool both = count_of(out.objects_before, c.object) >= kEnoughPoints &&
                      count_of(out.objects_after, c.object) >= kEnoughPoints;
    out.can_be_told.push_back(c.what == Happened::kGaveWay ? both : was && is);
  }
  return out;
}

KnownEpochs known_street(uint64_t seed, bool is_unchanged) {
  constexpr double kTurn_rad = 17 * std::numbers::pi / 180;  // of the scene
  constexpr double kAbout_m = 0.02;                          // the noise of a thing's points
  struct Place {
    Happened what;
    double size_m;
    Box3 box;
  };
  const Place places[] = {
      {Happened::kGaveWay, 0.02, {{24, 8.3, 0.05}, {30, 8.4, 1.15}}},
      {Happened::kGaveWay, 0.1, {{44, 7.6, 0.05}, {50, 7.8, 1.15}}},
      {Happened::kGaveWay, 0.02, {{10, -8.25, 0.05}, {16, -8.1, 1.15}}},
      {Happened::kGaveWay, 0.005, {{22, -8.05, 0.05}, {38, -7.95, 1.15}}},
      {Happened::kCame, 1.5, {{22, -4.6, 0}, {26.2, -2.8, 1.5}}},
      {Happened::kCame, 6, {{26.9, 3.9, 0}, {27.1, 4.1, 6}}},
      {Happened::kWent, 1.4, {{32, -4.5, 0}, {36.4, -2.7, 1.4}}},
  };
  const auto scan = [&](int epoch, uint64_t scan_seed) {
    const std::string scene = "{\"name\": \"street\", \"epoch\": " + std::to_string(epoch) + "}";
    const Recipe made(scene.c_str(), "static",
                      "{\"horizontal_step_rad\": 0.006, \"vertical_step_rad\": 0.006}", scan_seed);
    auto cloud = std::make_shared<Cloud>(*made.cloud);
    cloud->stations.clear();
    return cloud;
  };
  KnownEpochs out;
  out.before = scan(1, 2 * seed);
  out.after = scan(is_unchanged ? 1 : 2, 2 * seed + 1);
  const auto objects = [&](const Cloud& cloud, bool is_after) {
    std::vector<uint32_t> of(cloud.size(), kFloor);
    const double c = std::cos(kTurn_rad), s = std::sin(kTurn_rad);
    const Vec3 margin{kAbout_m, kAbout_m, kAbout_m};
    for (size_t i = 0; !is_unchanged && i < of.size(); ++i) {
      const Vec3 p = cloud.point(i), at{c * p.x + s * p.y, -s * p.x + c * p.y, p.z};
      for (uint32_t k = 0; k < std::size(places); ++k) {
        const Place& place = places[k];
        const bool is_there =
            place.what == Happened::kGaveWay || is_after == (place.what == Happened::kCame);
        if (is_there && at.z > kAbout_m &&
            Box3{place.box.min - margin, place.box.max + margin}.contains(at))
          of[i] = kFirstThing + k;
      }
    }
    return of;
  };
  out.objects_before = objects(*out.before, false);
  out.objects_after = objects(*out.after, true);
  for (uint32_t k = 0; !is_unchanged && k < std::size(places); ++k)
    out.changes.push_back({kFirstThing + k, places[k].what, places[k].size_m});
  out.can_be_told.assign(out.changes.size(), 1);
  return out;
}

namespace {

ScoredRun scored_run(const KnownEpochs& epochs, const BothWays& detected, double threshold_m) {
  Task task;
  RegionSettings settings;
  settings.criterion = RegionSettings::Criterion::kThreshold;
  settings.threshold_m = threshold_m;
  const Diagnosis found = diagnose(detected.forward, detected.reverse, settings, task);
  ScoredRun out;
  out.threshold_m = threshold_m;
  out.changes_of_kind = epochs.changes.size();
  std::map<uint32_t, std::vector<Statement>> about;
  for (const Change& change : found.changes) {
    const Statement s = statement_of(change, found, epochs);
    if (!s.is_right)
      ++out.confusion[truth_of(s.object, epochs) + " > " + name_of(happened(s.change_class))];
    about[s.object].push_back(s);
    out.statements.push_back(s);
  }
  for (const Change& change : found.untold)
    out.untold.push_back(statement_of(change, found, epochs));
  for (const Change& change : found.weighed)
    out.weighed.push_back(statement_of(change, found, epochs));
  for (size_t k = 0; k < epochs.changes.size(); ++k) {
    const TrueChange& c = epochs.changes[k];
    if (epochs.can_be_told[k] == 0 || c.size_m < kClearly * threshold_m) continue;
    ++out.planted;
    const std::vector<Statement>& said = about[c.object];
    const bool is_found =
        std::any_of(said.begin(), said.end(), [](const Statement& s) { return s.is_right; });
    out.found += is_found ? 1 : 0;
    if (said.empty()) ++out.confusion[std::string(name_of(c.what)) + " > unsaid"];
  }
  return out;
}

}  // namespace

std::vector<ScoredRun> scored_runs(const std::string& kind, const KnownEpochs& epochs,
                                   uint64_t seed) {
  std::vector<ScoredRun> out;
  for (const bool has_stations : {true, false}) {
    const BothWays both{detected(epochs.before, epochs.after, has_stations),
                        detected(epochs.after, epochs.before, has_stations)};
    for (const double threshold_m : {0.02, 0.05}) {
      out.push_back(scored_run(epochs, both, threshold_m));
      out.back().kind = kind;
      out.back().seed = seed;
      out.back().has_stations = has_stations;
    }
  }
  return out;
}

ConfidenceFigures figures_of(const std::vector<ScoredRun>& runs) {
  constexpr double kSure = 0.9;
  constexpr size_t kBins = 10;
  ConfidenceFigures out;
  std::vector<std::pair<double, bool>> told;
  for (const ScoredRun& run : runs) {
    out.planted += run.planted;
    out.found += run.found;
    if (run.changes_of_kind == 0) {
      ++out.unchanged;
      out.unchanged_clean += run.statements.empty() ? 1 : 0;
    }
    for (const Statement& s : run.statements) {
      told.emplace_back(s.confidence, s.is_right);
      out.about_changed += s.is_changed ? 1 : 0;
      out.right_class += s.is_right ? 1 : 0;
      out.sure += s.confidence >= kSure ? 1 : 0;
      out.sure_right += s.confidence >= kSure && s.is_right ? 1 : 0;
    }
  }
  out.statements = told.size();
  std::sort(told.begin(), told.end());
  std::ostringstream bins;
  bins.precision(2);
  bins << std::fixed;
  for (size_t b = 0; b < kBins; ++b) {
    const size_t from = b * told.size() / kBins, to = (b + 1) * told.size() / kBins;
    if (from == to) continue;
    double said = 0, right = 0;
    for (size_t k = from; k < to; ++k) {
      said += told[k].first;
      right += told[k].second ? 1 : 0;
    }
    out.expected_error += std::abs(said - right) / static_cast<double>(told.size());
    const auto n = static_cast<double>(to - from);
    bins << " " << said / n << ":" << right / n;
  }
  out.bins = bins.str();
  return out;
}

std::string text_of(const ConfidenceFigures& f) {
  std::ostringstream out;
  out.precision(3);
  out << f.statements << " statements, " << f.about_changed << " about what changed, class right "
      << f.class_right() << "; planted that can be told " << f.planted
      << ", found with their class " << f.found_right() << "; confidence >= 0.9: " << f.sure
      << ", right " << f.sure_share() << "; expected calibration error " << f.expected_error << " ("
      << f.bins << " ); unchanged runs " << f.unchanged << ", nothing invented " << f.clean();
  return out.str();
}

std::string confusion_of(const std::vector<ScoredRun>& runs) {
  std::map<std::string, std::map<std::string, size_t>> by_kind;
  std::map<std::string, std::array<size_t, 3>> of_kind;
  for (const ScoredRun& run : runs) {
    auto& counts = of_kind[run.kind];
    counts[0] += run.statements.size();
    counts[1] += run.planted;
    counts[2] += run.found;
    for (const auto& [what, n] : run.confusion) by_kind[run.kind][what] += n;
  }
  std::ostringstream out;
  for (const auto& [kind, counts] : of_kind) {
    out << "\n  " << kind << ": " << counts[0] << " statements, found " << counts[2] << " of "
        << counts[1];
    for (const auto& [what, n] : by_kind[kind]) out << "; " << what << " " << n;
  }
  return out.str();
}

}  // namespace jalon::test
