// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.util.Map;

/** Arrays whose shape means something: poses, and choices of points that are empty. */
final class Shapes {
  /** One point, 1 m beside the path of a box that is 1 m wide. */
  private static final double[] BESIDE = {5, 1, 0};

  private Shapes() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("shapes__poses_are_3_x_4_or_4_x_4_in_every_form", Shapes::poses);
    all.put("shapes__48_numbers_are_four_poses_or_three", Shapes::fortyEight);
    all.put("shapes__what_is_no_list_of_poses_is_refused_by_name", Shapes::wrongPoses);
    all.put("shapes__a_pose_has_12_numbers_or_16", Shapes::onePose);
    all.put("shapes__an_empty_choice_of_points_is_not_all_of_them", Shapes::noPoints);
    all.put("shapes__a_sphere_of_chosen_points", Shapes::chosen);
    all.put("shapes__what_c_lets_be_null_is_left_out", Shapes::leftOut);
  }

  /** A pose without a turn at x, with or without its last row. */
  private static double[] at(double x, boolean square) {
    return square ? new double[] {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1} : new double[] {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0};
  }

  private static double[][] path(int count, boolean square) {
    final double[][] path = new double[count][];
    for (int i = 0; i < count; ++i) {
      path[i] = at(4.0 * i, square);
    }
    return path;
  }

  private static double[] flat(double[][] rows) {
    return java.util.Arrays.stream(rows).flatMapToDouble(java.util.Arrays::stream).toArray();
  }

  /** The same numbers in rows of four. */
  private static double[][] fours(double[][] rows) {
    final double[] all = flat(rows);
    final double[][] made = new double[all.length / 4][];
    for (int i = 0; i < made.length; ++i) {
      made[i] = java.util.Arrays.copyOfRange(all, 4 * i, 4 * i + 4);
    }
    return made;
  }

  /** Clearances of the ways from each pose to the next, whose box passes or stops short of the point. */
  private static void check(int poses, GaugeSweepResult swept) {
    try (swept) {
      final double[] clearance = swept.intervals().doubles("clearance");
      same(Math.max(1, poses - 1), clearance.length);
      if (poses > 2) { // the second way, from 4 to 8 m, goes past the point
        expect(Math.abs(clearance[0] - Math.hypot(0.5, 0.5)) < 1e-9 && Math.abs(clearance[1] - 0.5) < 1e-9,
            java.util.Arrays.toString(clearance));
      }
    }
  }

  private static void poses() {
    final Gauge box = Survey.gauge();
    try (Cloud cloud = Cloud.create(BESIDE)) {
      for (boolean square : new boolean[] {false, true}) {
        for (int count : new int[] {1, 2, 3, 4, 12, 16}) {
          final double[][] path = path(count, square);
          check(count, Jalon.gaugeSweep(box, path, cloud));
          check(count, Jalon.gaugeSweep(box, fours(path), cloud));
          check(count, Jalon.gaugeSweep(box, flat(path), cloud));
          check(count, Jalon.gaugeSweep(box, Rows.of(flat(path)).by(path[0].length), cloud));
        }
      }
    }
  }

  private static void fortyEight() {
    final Gauge box = Survey.gauge();
    try (Cloud cloud = Cloud.create(BESIDE)) {
      same(48, flat(path(3, true)).length);
      same(48, flat(path(4, false)).length);
      same(2, Jalon.gaugeSweep(box, flat(path(3, true)), cloud).intervals().doubles("clearance").length);
      same(3, Jalon.gaugeSweep(box, flat(path(4, false)), cloud).intervals().doubles("clearance").length);
    }
  }

  private static void wrongPoses() {
    final Gauge box = Survey.gauge();
    final double[][] broken = path(2, true);
    broken[1][15] = 2;
    try (Cloud cloud = Cloud.create(BESIDE)) {
      for (Behaviours.Body wrong : new Behaviours.Body[] {
          () -> Jalon.gaugeSweep(box, new double[20], cloud), () -> Jalon.gaugeSweep(box, new double[2][11], cloud),
          () -> Jalon.gaugeSweep(box, new double[12][1], cloud),
          () -> Jalon.gaugeSweep(box, new double[4][3], cloud), () -> Jalon.gaugeSweep(box, new double[5][4], cloud)}) {
        final String message = thrown(InvalidArgumentException.class, wrong).getMessage();
        expect(message.startsWith("poses must be 12 numbers a pose (3 x 4), or 16 (4 x 4), not "), message);
      }
      for (Behaviours.Body wrong : new Behaviours.Body[] {
          () -> Jalon.gaugeSweep(box, broken, cloud), () -> Jalon.gaugeSweep(box, flat(broken), cloud)}) {
        same("poses[1] must have the last row 0 0 0 1", thrown(InvalidArgumentException.class, wrong).getMessage());
      }
    }
  }

  private static void onePose() {
    try (Cloud cloud = Cloud.create(BESIDE)) {
      for (boolean square : new boolean[] {false, true}) {
        try (Cloud moved = cloud.transform(at(7, square))) {
          same(12.0, moved.points().doubles().get(0));
        }
      }
      same("transform must have 12 numbers (3 x 4), or 16 (4 x 4), not 9",
          thrown(InvalidArgumentException.class, () -> cloud.transform(new double[9])).getMessage());
      same("transform must have the last row 0 0 0 1",
          thrown(InvalidArgumentException.class, () -> cloud.transform(new double[16])).getMessage());
      same("box must have 6 numbers, not 5", thrown(InvalidArgumentException.class, () -> cloud.cropBox(new double[5])).getMessage());
    }
  }

  private static void noPoints() {
    final double[] up = {0, 0, 1};
    try (Cloud cloud = Survey.copy(Survey.get().ball)) {
      for (Behaviours.Body empty : new Behaviours.Body[] {
          () -> cloud.fitSphere(new long[0]), () -> cloud.fitSphere(new int[0]), () -> cloud.fitSphere(LongBuffer.allocate(0)),
          () -> cloud.fitSphere(IntBuffer.allocate(0)), () -> cloud.fitSphere(Rows.of(new long[0])), () -> cloud.fitCircle(new long[0]),
          () -> cloud.fitCylinder(new long[0], up), () -> cloud.rangePrecision(new long[0])}) {
        same("indices means no point: where all points are meant, leave it out",
            thrown(InsufficientDataException.class, empty).getMessage());
      }
      final boolean[] none = new boolean[(int) cloud.count()];
      for (Behaviours.Body empty : new Behaviours.Body[] {
          () -> cloud.fitSphere(none), () -> cloud.fitCircle(none), () -> cloud.fitCylinder(none, up), () -> cloud.rangePrecision(none),
          () -> cloud.computeGeodesic(none)}) {
        same("the mask means no point", thrown(InsufficientDataException.class, empty).getMessage());
      }
      thrown(InsufficientDataException.class, () -> cloud.computeGeodesic(new long[0]));
    }
  }

  private static void chosen() {
    try (Cloud cloud = Survey.copy(Survey.get().ball)) {
      final boolean[] half = new boolean[(int) cloud.count()];
      java.util.Arrays.fill(half, 0, half.length / 2, true);
      same(half.length / 2.0, cloud.rangePrecision(half).doubles("points")[0]);
      same((double) half.length, cloud.rangePrecision().doubles("points")[0]);
      expect(Math.abs(cloud.fitSphere().doubles("radius")[0] - 0.0725) < 1e-9, "all points");
    }
  }

  private static void leftOut() {
    final Survey survey = Survey.get();
    try (Model outlines = survey.comparison.outlines(survey.forwardPoints); Cloud pipe = Survey.copy(survey.pipe)) {
      expect(outlines.partCount() >= 1, "no part \"changes\"");
      expect(Math.abs(pipe.fitCylinder().doubles("radius")[0] - 0.3) < 1e-6, "a free cylinder of all points");
    }
  }
}
