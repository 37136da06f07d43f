// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "scan/grammar/dice.h"
#include "scan/grammar/plan.h"

namespace jalon::grammar {

/// How the windows of a storey look.
struct WindowStyle {
  double width_m = 1.1, height_m = 1.6, sill_m = 0.9;  ///< sill: over the floor
  Shape::Form form = Shape::Form::kFlat;
  double rise_m = 0.12;
  double depth_m = 0.2;
  double surround_m = 0, proud_m = 0.04;
  bool has_sill = false, has_shutters = false;
  int mullions = 1, transoms = 0;
  double blinds = 0, curtains = 0.3;  ///< shares of the windows
};

/// Makes a plan. Openings that leave their wall or come too near to another are left out, pads too: kinds place what
/// they like.
class Sketch {
 public:
  Sketch(const GrammarSettings& asked, Plan& plan, Dice& dice)
      : asked_(asked), plan_(plan), dice_(dice) {}
  Plan& plan() { return plan_; }
  Dice& dice() { return dice_; }

  /// Length of the front and number of storeys: those asked for, else between these.
  std::pair<double, int> sizes(double least_m, double most_m, int fewest, int most);
  /// Levels of the floors: the ground floor of one height, the others of another that shrinks upward.
  void storeys(int count, double ground_m, double upper_m, double shrink = 1);
  double floor(int storey) const { return plan_.floors_m[static_cast<size_t>(storey)]; }
  double eaves() const { return plan_.floors_m.back(); }
  int storey_count() const { return static_cast<int>(plan_.floors_m.size()) - 1; }

  /// The walls' numbers stay; references last until the next one.
  size_t wall(std::string name, double y_m, Contour outline);
  PlannedWall& at(size_t wall) { return plan_.walls[wall]; }

  bool open(size_t wall, PlannedOpening opening);
  bool window(size_t wall, const WindowStyle& style, double middle_u, int storey);
  /// Of a storey on all axes; some may be left out.
  void window_row(size_t wall, const WindowStyle& style, const std::vector<double>& axes,
                  int storey, double blind_axes = 0);
  bool door(size_t wall, double middle_u, double width_m, double height_m, double depth_m);
  /// Glass between posts over a low panel.
  bool shop_front(size_t wall, double u0, double u1, double height_m, double depth_m);
  bool vent(size_t wall, double middle_u, double low_v, double width_m, double height_m);
  /// A closed box in the wall: letters, a meter, money.
  bool niche(size_t wall, double middle_u, double low_v, double width_m, double height_m);
  /// A recess with a back wall of its own, whose number it gives back; no wall: SIZE_MAX.
  size_t recess(size_t wall, const Rect& rect, double depth_m, int storey);

  bool pad(size_t wall, const char* part_class, const Rect& rect, double low_m, double high_m);
  /// A beam from one corner of a panel to the other, below left to above right.
  bool brace(size_t wall, const Vec2& foot, const Vec2& head, double width_m, double proud_m);
  /// A long band, in pieces between the openings.
  void band(size_t wall, const char* part_class, double v0, double v1, double proud_m);
  void plinth(size_t wall);
  void cornice(size_t wall, double top_v);
  void balcony(size_t wall, double u0, double u1, double v, double depth_m, bool is_solid);
  void sign(size_t wall, double u0, double u1, double v0, double v1);
  /// Slopes down from the wall.
  void canopy(size_t wall, double u0, double u1, double v, double reach_m);
  /// Corner stones, one long, one short.
  void quoins(size_t wall, double top_v);
  /// What hangs on walls: coolers, lamps, signs across the pavement, ducts.
  void clutter(size_t wall, int most);
  void drainpipe(size_t wall, double u, double top_v);
  void roof(double u0, double u1, double v, double y_m);
  /// The sides between two walls beside each other.
  void joint(double u, double from_y_m, double to_y_m, double top_v);
  /// What goes with the openings, once all are there: surrounds, sills, shutters.
  void finish();
  void finish(size_t wall);

  std::vector<double> axes(double u0, double u1, int count) const;
  /// As many axes as there is room for, one every so many metres.
  std::vector<double> axes_by(double u0, double u1, double least_m, double most_m);

 private:
  bool is_free(const PlannedWall& wall, const Contour& contour) const;
  bool is_free_of_pads(const PlannedWall& wall, const Rect& rect) const;
  bool is_clear(const PlannedWall& wall, const Rect& rect) const;
  bool add_pad(PlannedWall& wall, Pad pad);
  void trim(PlannedWall& wall, const PlannedOpening& opening);

  const GrammarSettings& asked_;
  Plan& plan_;
  Dice& dice_;
};

// One function a kind.
void plan_town_house(Sketch& sketch);
void plan_apartments(Sketch& sketch);
void plan_shops(Sketch& sketch);
void plan_arcade(Sketch& sketch);
void plan_offices(Sketch& sketch);
void plan_gabled(Sketch& sketch);
void plan_wings(Sketch& sketch);
void plan_loggias(Sketch& sketch);
void plan_church(Sketch& sketch);
void plan_factory(Sketch& sketch);
void plan_terrace(Sketch& sketch);
void plan_mansard(Sketch& sketch);
void plan_timbered(Sketch& sketch);
void plan_villa(Sketch& sketch);
void plan_school(Sketch& sketch);
void plan_sheds(Sketch& sketch);
void plan_nave(Sketch& sketch);
void plan_warehouse(Sketch& sketch);
void plan_staggered(Sketch& sketch);
void plan_corner(Sketch& sketch);
void plan_mill(Sketch& sketch);
void plan_inn(Sketch& sketch);
void plan_parade(Sketch& sketch);

}  // namespace jalon::grammar
