// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using Jalon;

/// <summary>Arrays whose shape means something: poses, boxes, and choices of points that are empty.</summary>
static class Shapes {
  static double[] At(double x, bool square) {
    var pose = new[] {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0};
    return square ? pose.Concat(new double[] {0, 0, 0, 1}).ToArray() : pose;
  }

  static double[][] Path(int count, bool square) {
    return Enumerable.Range(0, count).Select(i => At(4.0 * i, square)).ToArray();
  }

  static double[] Flat(double[][] rows) {
    return rows.SelectMany(row => row).ToArray();
  }

  static double[,] Rows(double[] numbers, int columns) {
    var rows = new double[numbers.Length / columns, columns];
    Buffer.BlockCopy(numbers, 0, rows, 0, numbers.Length * sizeof(double));
    return rows;
  }

  static Gauge Box() {
    var box = new Gauge();
    box.AddBox(new double[] {1, 1, 2});
    return box;
  }

  /// <summary>Clearances of the ways from each pose to the next; the second, from 4 to 8 m, goes past a point 1 m beside.</summary>
  static double[] Swept(ArrayArgument poses) {
    using (var cloud = new Cloud(new double[] {5, 1, 0}))
    using (Gauge box = Box())
    using (GaugeSweepResult swept = Library.GaugeSweep(box, poses, cloud)) return swept.Intervals.Doubles("clearance");
  }

  static void Passes(int poses, ArrayArgument path) {
    double[] clearance = Swept(path);
    Check.Equal(Math.Max(1, poses - 1), clearance.Length, "ways of " + poses + " poses");
    if (poses > 2) Check.That(Math.Abs(clearance[0] - Math.Sqrt(0.5)) < 1e-9 && Math.Abs(clearance[1] - 0.5) < 1e-9, string.Join(" ", clearance));
  }

  public static void Poses__are_3_x_4_or_4_x_4_in_every_form() {
    foreach (bool square in new[] {false, true}) {
      foreach (int count in new[] {1, 2, 3, 4, 12, 16}) {
        double[][] path = Path(count, square);
        Passes(count, path);
        Passes(count, Flat(path));
        Passes(count, Rows(Flat(path), 4));
        Passes(count, Rows(Flat(path), path[0].Length));
      }
    }
    Check.Equal(48, Flat(Path(3, true)).Length, "three 4 x 4");
    Check.Equal(48, Flat(Path(4, false)).Length, "four 3 x 4");
    Check.Equal(2, Swept(Flat(Path(3, true))).Length, "three 4 x 4");
    Check.Equal(3, Swept(Flat(Path(4, false))).Length, "four 3 x 4");
  }

  public static void Poses__of_a_wrong_shape_are_refused_by_name() {
    foreach (ArrayArgument each in new ArrayArgument[] {new double[20], new double[2, 11], new double[4, 3], new double[5, 4]}) {
      ArrayArgument wrong = each;
      string message = Check.Throws<InvalidArgumentException>(() => Swept(wrong)).Message;
      Check.That(message.StartsWith("poses must be 12 numbers a pose (3 x 4), or 16 (4 x 4), not "), message);
    }
    double[][] broken = Path(2, true);
    broken[1][15] = 2;
    foreach (ArrayArgument each in new ArrayArgument[] {broken, Flat(broken)}) {
      ArrayArgument wrong = each;
      Check.Equal("poses[1] must have the last row 0 0 0 1", Check.Throws<InvalidArgumentException>(() => Swept(wrong)).Message, "message");
    }
  }

  public static void Small_arrays__have_their_shape_not_only_their_size() {
    using (var cloud = new Cloud(new double[] {5, 1, 0})) {
      foreach (ArrayArgument shift in new ArrayArgument[] {At(7, false), At(7, true), Rows(At(7, false), 4), Rows(At(7, true), 4)}) {
        using (Cloud moved = cloud.Transform(shift)) Check.Equal(12.0, moved.GetPoints()[0], "moved");
      }
      foreach (ArrayArgument box in new ArrayArgument[] {new double[] {0, 0, 0, 9, 9, 9}, new double[,] {{0, 0, 0}, {9, 9, 9}}}) {
        using (CloudCropBoxResult halves = cloud.CropBox(box)) Check.Equal(1L, halves.Inside.Count, "inside");
      }
      Action[] calls = {() => cloud.Transform(Rows(At(7, false), 3)), () => cloud.Transform(Rows(At(7, true), 2)), () => cloud.Transform(new double[9]),
                        () => cloud.CropBox(new double[3, 2]), () => cloud.Transform(new double[4, 4])};
      string[] messages = {"transform must be 3 x 4 or 4 x 4, not 4 x 3", "transform must be 3 x 4 or 4 x 4, not 8 x 2",
                           "transform must have 12 numbers (3 x 4), or 16 (4 x 4), not 9", "box must be 2 x 3, not 3 x 2",
                           "transform must have the last row 0 0 0 1"};
      for (int i = 0; i < calls.Length; ++i) Check.Equal(messages[i], Check.Throws<InvalidArgumentException>(calls[i]).Message, "message " + i);
    }
  }

  public static void An_empty_choice_of_points__is_not_all_of_them() {
    var up = new double[] {0, 0, 1};
    using (Cloud cloud = Survey.CopyOf(Survey.Sphere)) {
      Action[] empty = {() => cloud.FitSphere(new long[0]), () => cloud.FitSphere(new int[0]), () => cloud.FitCircle(new ulong[0]),
                        () => cloud.FitCylinder(new long[0], up), () => cloud.RangePrecision(new long[0])};
      foreach (Action call in empty) {
        Check.Equal("indices means no point: where all points are meant, leave it out",
                    Check.Throws<InsufficientDataException>(call).Message, "message");
      }
      var none = new bool[cloud.Count];
      Action[] masked = {() => cloud.FitSphere(none), () => cloud.FitCircle(none), () => cloud.FitCylinder(none, up),
                         () => cloud.RangePrecision(none), () => cloud.ComputeGeodesic(none)};
      foreach (Action call in masked) Check.Equal("the mask means no point", Check.Throws<InsufficientDataException>(call).Message, "message");
      Check.Throws<InsufficientDataException>(() => cloud.ComputeGeodesic(new long[0]));
      var half = new bool[cloud.Count];
      for (int i = 0; i < half.Length / 2; ++i) half[i] = true;
      Check.Equal(half.Length / 2.0, cloud.RangePrecision(half).Doubles("points")[0], "half of them");
      Check.Equal((double)half.Length, cloud.RangePrecision().Doubles("points")[0], "all of them");
    }
  }

  public static void What_c_lets_be_null__is_left_out() {
    using (Cloud pipe = Survey.CopyOf(Survey.Pipe)) Check.That(Math.Abs(pipe.FitCylinder().Doubles("radius")[0] - 0.3) < 1e-6, "a free cylinder");
    using (Model outlines = Survey.Forward.Outlines(Survey.Diagnosis.Forward)) Check.That(outlines.PartCount >= 1, "no part \"changes\"");
  }
}
