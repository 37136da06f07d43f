// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes/grid_facade.h"

#include <string>
#include <vector>

namespace jalon {

namespace {

constexpr Vec3 kGridFacadeX{1, 0, 0}, kGridFacadeY{0, 1, 0}, kGridFacadeZ{0, 0, 1};

/// Upright, seen from the front, at this depth: u is x, v is z.
Frame upright(double y) { return {kGridFacadeY * y, kGridFacadeX, kGridFacadeZ}; }
/// Upright, looking along -X or +X at this x; u is z and v is y, or the other way round.
Frame looking_left(double x) { return {kGridFacadeX * x, kGridFacadeZ, kGridFacadeY}; }
Frame looking_right(double x) { return {kGridFacadeX * x, kGridFacadeY, kGridFacadeZ}; }
/// Level, looking up (u is x, v is y) or down (u is y, v is x) at this height.
Frame looking_up(double z) { return {kGridFacadeZ * z, kGridFacadeX, kGridFacadeY}; }
Frame looking_down(double z) { return {kGridFacadeZ * z, kGridFacadeY, kGridFacadeX}; }

class Builder {
 public:
  Builder(const GridFacade& facade, RandomStream random, SceneBuilder& out)
      : f_(facade), random_(random), out_(out) {}

  uint32_t build() {
    house_ = out_.part("facade", "facade");
    wall_ = out_.part("wall", "wall", house_);
    posts_ = out_.part("posts and bands", "post", house_);
    slabs_ = out_.part("slabs", "band", house_);
    breasts_ = out_.part("breast walls", "breast_wall", house_);
    mullions_ = out_.part("mullions", "mullion", house_);
    add_walls();
    add_lattice();
    for (int i = 0; i <= f_.bays; ++i) add_post_sides(i);
    for (int i = 0; i < f_.bays; ++i)
      for (int k = 0; k < f_.storeys; ++k) add_cell(i, k);
    add_cornice();
    return house_;
  }

 private:
  double left(int bay) const { return f_.post_x(bay) + f_.post_width_m; }
  double right(int bay) const { return f_.post_x(bay + 1); }
  double floor(int storey) const { return storey * f_.storey_height_m; }
  double attic() const { return floor(f_.storeys); }
  double window_top() const { return f_.breast_height_m + f_.window_height_m; }
  bool has_lintel() const { return window_top() < f_.clear_height() - 1e-9; }

  /// The closed wall, and what is left of its plane above the windows, between the posts.
  void add_walls() {
    out_.face(wall_, upright(f_.wall_y), {0, f_.wall_width_m, 0, f_.cornice_z});
    for (int i = 0; i < f_.bays; ++i)
      out_.face(wall_, upright(f_.wall_y), {left(i), right(i), attic(), f_.cornice_z});
  }

  /// The fronts of posts and bands: one plane, one piece.
  void add_lattice() {
    std::vector<Rect> openings;
    for (int i = 0; i < f_.bays; ++i) {
      for (int k = 0; k < f_.storeys; ++k)
        openings.push_back({left(i), right(i), floor(k), floor(k) + f_.clear_height()});
      openings.push_back({left(i), right(i), attic(), f_.cornice_z});
    }
    out_.face(posts_, upright(f_.front_y), {f_.wall_width_m, f_.width(), 0, f_.cornice_z},
              openings);
  }

  /// Sides reach back to what stands between the posts: breast wall, glass, lintel, or the wall above.
  void add_post_sides(int i) {
    const double x0 = f_.post_x(i), x1 = x0 + f_.post_width_m;
    if (i == 0) out_.face(posts_, looking_left(x0), {0, f_.cornice_z, f_.front_y, f_.wall_y});
    if (i == f_.bays)
      out_.face(posts_, looking_right(x1), {f_.front_y, f_.glass_y, 0, f_.cornice_z});
    for (int k = 0; k < f_.storeys; ++k) {
      const double z0 = floor(k), z1 = z0 + f_.clear_height();
      const double sill = z0 + f_.breast_height_m, head = z0 + window_top();
      if (i > 0) {
        std::vector<Rect> taken{{z0, sill, f_.breast_y, f_.glass_y}};
        if (has_lintel()) taken.push_back({head, z1, f_.breast_y, f_.glass_y});
        out_.face(posts_, looking_left(x0), {z0, z1, f_.front_y, f_.glass_y}, taken);
      }
      if (i < f_.bays) {
        std::vector<Rect> taken{{f_.breast_y, f_.glass_y, z0, sill}};
        if (has_lintel()) taken.push_back({f_.breast_y, f_.glass_y, head, z1});
        out_.face(posts_, looking_right(x1), {f_.front_y, f_.glass_y, z0, z1}, taken);
      }
    }
    if (i > 0) out_.face(posts_, looking_left(x0), {attic(), f_.cornice_z, f_.front_y, f_.wall_y});
    if (i < f_.bays)
      out_.face(posts_, looking_right(x1), {f_.front_y, f_.wall_y, attic(), f_.cornice_z});
  }

  /// What fills one bay of one storey.
  void add_cell(int i, int k) {
    const double x0 = left(i), x1 = right(i), z0 = floor(k), sill = z0 + f_.breast_height_m,
                 head = z0 + window_top();
    // 1. Breast wall, and the same above the windows where the storey is higher than they reach.
    out_.face(breasts_, upright(f_.breast_y), {x0, x1, z0, sill});
    if (has_lintel())
      out_.face(breasts_, upright(f_.breast_y), {x0, x1, head, z0 + f_.clear_height()});
    // 2. The band above: its soffit, back to the lintel or the glass, and its top.
    out_.face(slabs_, looking_down(z0 + f_.clear_height()),
              {f_.front_y, has_lintel() ? f_.breast_y : f_.glass_y, x0, x1});
    out_.face(slabs_, looking_up(floor(k + 1)),
              {x0, x1, f_.front_y, k + 1 < f_.storeys ? f_.breast_y : f_.wall_y});
    // 3. Mullions, and the windows between them.
    double from = x0;
    for (int m = 1; m <= f_.mullions; ++m) {
      const double middle =
          f_.wall_width_m + i * f_.bay_width_m + m * f_.bay_width_m / (f_.mullions + 1);
      const double to = middle - f_.mullion_width_m / 2;
      add_window(from, to, sill, head);
      add_mullion(to, to + f_.mullion_width_m, sill, head);
      from = to + f_.mullion_width_m;
    }
    add_window(from, x1, sill, head);
    if (f_.balcony_depth_m > 0 && k > 0 && i % 2 == 0) add_balcony(x0, x1, z0);
  }

  void add_mullion(double x0, double x1, double sill, double head) {
    out_.face(mullions_, upright(f_.mullion_y), {x0, x1, sill, head});
    out_.face(mullions_, looking_left(x0), {sill, head, f_.mullion_y, f_.glass_y});
    out_.face(mullions_, looking_right(x1), {f_.mullion_y, f_.glass_y, sill, head});
    if (f_.mullion_y < f_.breast_y)
      out_.face(mullions_, looking_down(sill), {f_.mullion_y, f_.breast_y, x0, x1});
    if (f_.mullion_y < f_.breast_y && has_lintel())
      out_.face(mullions_, looking_up(head), {x0, x1, f_.mullion_y, f_.breast_y});
  }

  /// Sill and head, the glass unless the window is open, and perhaps a curtain behind it.
  void add_window(double x0, double x1, double sill, double head) {
    const uint32_t window = out_.part("window", "window", house_);
    out_.face(out_.part("sill", "sill", window), looking_up(sill),
              {x0, x1, f_.breast_y, f_.glass_y});
    if (has_lintel())
      out_.face(out_.part("head", "reveal", window), looking_down(head),
                {f_.breast_y, f_.glass_y, x0, x1});
    const double drawn = random_.uniform(), depth = random_.uniform();
    if (drawn < f_.open_share) return;
    out_.face(out_.part("glass", "glass", window), upright(f_.glass_y), {x0, x1, sill, head});
    if (drawn >= f_.open_share + f_.curtain_share) return;
    const double y = f_.curtain_nearest_y + (f_.curtain_farthest_y - f_.curtain_nearest_y) * depth;
    out_.face(out_.part("curtain", "curtain", window), upright(y), {x0, x1, sill, head});
  }

  /// A tray before the front: slab and solid parapet, 10 cm thick, 1 m high, as wide as half the bay.
  void add_balcony(double bay_left, double bay_right, double z) {
    constexpr double kThick = 0.10, kParapet = 1.0;
    const double quarter = (bay_right - bay_left) / 4, x0 = bay_left + quarter,
                 x1 = bay_right - quarter;
    const double y0 = f_.front_y - f_.balcony_depth_m, y1 = f_.front_y, bottom = z - kThick,
                 top = z + kParapet;
    const uint32_t balcony = out_.part("balcony", "balcony", house_);
    out_.face(balcony, upright(y0), {x0, x1, bottom, top});
    out_.face(balcony, looking_left(x0), {bottom, top, y0, y1});
    out_.face(balcony, looking_right(x1), {y0, y1, bottom, top});
    out_.face(balcony, looking_down(bottom), {y0, y1, x0, x1});
    const double i0 = x0 + kThick, i1 = x1 - kThick, iy = y0 + kThick;
    out_.face(balcony, looking_up(z), {i0, i1, iy, y1});
    out_.face(balcony, {kGridFacadeY * iy, kGridFacadeZ, kGridFacadeX}, {z, top, i0, i1});
    out_.face(balcony, looking_right(i0), {iy, y1, z, top});
    out_.face(balcony, looking_left(i1), {z, top, iy, y1});
    const Rect well{i0, i1, iy, y1};
    out_.face(balcony, looking_up(top), {x0, x1, y0, y1}, {&well, 1});
  }

  void add_cornice() {
    const uint32_t cornice = out_.part("cornice", "cornice", house_);
    const double z0 = f_.cornice_z, z1 = z0 + f_.cornice_height_m, width = f_.width();
    out_.face(cornice, looking_down(z0), {f_.cornice_y, f_.wall_y, 0, width});
    out_.face(cornice, upright(f_.cornice_y), {0, width, z0, z1});
    out_.face(cornice, looking_left(0), {z0, z1, f_.cornice_y, f_.wall_y});
    out_.face(cornice, looking_right(width), {f_.cornice_y, f_.wall_y, z0, z1});
    out_.face(cornice, looking_up(z1), {0, width, f_.cornice_y, f_.wall_y});
  }

  const GridFacade& f_;
  RandomStream random_;
  SceneBuilder& out_;
  uint32_t house_ = 0, wall_ = 0, posts_ = 0, slabs_ = 0, breasts_ = 0, mullions_ = 0;
};

}  // namespace

uint32_t build_grid_facade(const GridFacade& facade, RandomStream random, SceneBuilder& out) {
  return Builder(facade, random, out).build();
}

}  // namespace jalon
