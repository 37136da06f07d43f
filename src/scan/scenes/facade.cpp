// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "base/error.h"
#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

// Proportions of a plain town house; the sizes that matter to tests are parameters.
constexpr double kPlinthHeight_m = 0.60, kPlinthDepth_m = 0.05;
constexpr double kCorniceHeight_m = 0.50;
constexpr double kFacadeWindowWidth_m = 1.20, kDoorWidth_m = 1.30;
constexpr double kSillShare = 0.32, kLintelShare = 0.84;  // of a storey's height
constexpr double kGroundBeside_m = 4.0;
// Reveals of the storeys are 1.25, 1 and 0.75 times the parameter, in turn: planes that only their depth tells apart.
constexpr double kStoreyReveals[] = {1.25, 1.0, 0.75};
constexpr double kDoorReveal = 1.5;
constexpr Frame kGroundFrame{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
constexpr double kLeastBay_m = 1.60, kLeastStorey_m = 2.20;

struct Opening {
  Rect rect;
  double depth_m;
  bool is_door;
  int64_t storey, bay;
};

/// Doors stand in evenly chosen bays of the ground floor, windows in all others.
bool is_door_bay(int64_t bay, int64_t bays, int64_t doors) {
  for (int64_t d = 0; d < doors; ++d)
    if (bay == (2 * d + 1) * bays / (2 * doors)) return true;
  return false;
}

std::vector<Opening> openings_of(const SceneSettings& settings) {
  const double width = settings.width_m, height = settings.height_m - kCorniceHeight_m;
  const double reveal = settings.reveal_m;
  const int64_t bays = settings.bays, storeys = settings.storeys;
  const int64_t doors = std::min(settings.doors, bays);
  const double bay_width = width / static_cast<double>(bays),
               storey = height / static_cast<double>(storeys);
  if (bay_width < kLeastBay_m)
    fail(Status::kInvalidArgument, "%d bays are too many for the width", static_cast<int>(bays));
  if (storey < kLeastStorey_m)
    fail(Status::kInvalidArgument, "%d storeys are too many for the height",
         static_cast<int>(storeys));
  std::vector<Opening> out;
  for (int64_t s = 0; s < storeys; ++s)
    for (int64_t b = 0; b < bays; ++b) {
      const bool door = s == 0 && is_door_bay(b, bays, doors);
      const double middle = bay_width * (static_cast<double>(b) + 0.5),
                   half = (door ? kDoorWidth_m : kFacadeWindowWidth_m) / 2;
      const double floor = storey * static_cast<double>(s);
      const double sill = door ? 0 : std::max(floor + kSillShare * storey, kPlinthHeight_m);
      const double depth = reveal * (door ? kDoorReveal : kStoreyReveals[s % 3]);
      out.push_back(
          {{middle - half, middle + half, sill, floor + kLintelShare * storey}, depth, door, s, b});
    }
  return out;
}

/// Pieces of the plinth between the doors, with their tops and the ends at the doors.
void add_plinth(SceneBuilder& out, uint32_t house, double width,
                const std::vector<Opening>& openings, std::vector<Rect>& pieces) {
  const Vec3 x{1, 0, 0}, z{0, 0, 1};
  const uint32_t plinth = out.part("plinth", "plinth", house);
  const Frame front = Frame{{0, 0, 0}, x, z}.raised(kPlinthDepth_m);
  const Vec3 n = front.normal();
  double from = 0;
  const auto piece = [&](double to) {
    pieces.push_back({from, to, 0, kPlinthHeight_m});
    out.face(plinth, front, pieces.back());
    out.face(plinth, {{from, 0, kPlinthHeight_m}, n, x}, {0, kPlinthDepth_m, 0, to - from});
    out.face(plinth, {{to, 0, 0}, n * -1, z}, {-kPlinthDepth_m, 0, 0, kPlinthHeight_m});
    out.face(plinth, {{from, 0, 0}, n, z}, {0, kPlinthDepth_m, 0, kPlinthHeight_m});
  };
  for (const Opening& o : openings)
    if (o.is_door) {
      piece(o.rect.u0);
      from = o.rect.u1;
    }
  piece(width);
}

void add_cornice(SceneBuilder& out, uint32_t house, double width, double height, double depth) {
  if (!(depth > 0)) return;
  const Vec3 x{1, 0, 0}, z{0, 0, 1}, n{0, -1, 0};
  const uint32_t cornice = out.part("cornice", "cornice", house);
  const double foot = height - kCorniceHeight_m;
  out.face(cornice, {{0, -depth, 0}, x, z}, {0, width, foot, height});
  out.face(cornice, {{0, 0, foot}, x, n}, {0, width, 0, depth});
  out.face(cornice, {{0, 0, height}, n, x}, {0, depth, 0, width});
  out.face(cornice, {{0, 0, 0}, n, z}, {0, depth, foot, height});
  out.face(cornice, {{width, 0, 0}, z, n}, {foot, height, 0, depth});
}

/// Of ground that ends under the plinth what is seen in the doorways: a face each, for they do not hang together.
void add_doorway_grounds(SceneBuilder& out, double depth, const std::vector<Opening>& openings) {
  uint32_t ground = kNoPart;
  for (const Opening& o : openings) {
    if (!o.is_door) continue;
    if (ground == kNoPart) ground = out.part("ground", "ground");
    out.face(ground, kGroundFrame, {o.rect.u0, o.rect.u1, -depth, o.depth_m});
  }
}

/// Ground up to the plinth, and into the doorways as far as their leaves.
void add_ground(SceneBuilder& out, double width, double depth, const std::vector<Opening>& openings,
                const std::vector<Rect>& plinth) {
  if (!(depth > 0)) return;
  if (depth <= kPlinthDepth_m) return add_doorway_grounds(out, depth, openings);
  double back = 0;
  for (const Opening& o : openings)
    if (o.is_door) back = std::max(back, o.depth_m);
  std::vector<Rect> taken;
  for (const Rect& piece : plinth)
    taken.push_back({piece.u0 > 0 ? piece.u0 : -kGroundBeside_m,
                     piece.u1 < width ? piece.u1 : width + kGroundBeside_m, -kPlinthDepth_m, back});
  const uint32_t ground = out.part("ground", "ground");
  out.face(ground, kGroundFrame, {-kGroundBeside_m, width + kGroundBeside_m, -depth, back}, taken);
}

std::string number_text(int64_t storey, int64_t bay) {
  return std::to_string(storey + 1) + "." + std::to_string(bay + 1);
}

}  // namespace

void build_facade(const SceneSettings& settings, SceneBuilder& out) {
  const double width = settings.width_m, height = settings.height_m;
  const double cornice = settings.cornice_m;
  const std::vector<Opening> openings = openings_of(settings);
  const Frame front{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};

  // 1. The wall between plinth and cornice, doors cut in from below.
  const uint32_t house = out.part("facade", "facade");
  const uint32_t wall = out.part("wall", "wall", house);
  std::vector<Rect> holes;
  for (const Opening& o : openings) holes.push_back(o.rect);
  out.face(wall, front,
           {0, width, kPlinthHeight_m, cornice > 0 ? height - kCorniceHeight_m : height}, holes);

  // 2. What projects from it.
  std::vector<Rect> plinth;
  add_plinth(out, house, width, openings, plinth);
  add_cornice(out, house, width, height, cornice);

  // 3. What lies behind its openings.
  for (const Opening& o : openings) {
    const std::string number = number_text(o.storey, o.bay);
    const uint32_t part = o.is_door ? out.part("door " + number, "door", wall)
                                    : out.part("window " + number, "window", wall);
    out.recess(part, front, o.rect, o.depth_m, !o.is_door, o.is_door ? 0 : settings.frame_m);
  }

  // 4. The ground in front.
  add_ground(out, width, settings.ground_m, openings, plinth);
}

}  // namespace jalon
