// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Reflection;
using Jalon;

static class Arrays {
  static bool Same(double[,] rows, ArrayView view) {
    for (int i = 0; i < rows.GetLength(0); ++i) {
      for (int c = 0; c < 3; ++c) {
        if (rows[i, c] != view[i, c]) return false;
      }
    }
    return rows.GetLength(0) == view.Count;
  }

  public static void Rows__come_back_as_they_went_in() {
    double[,] xyz = Scenes.Plane(20);
    using (var cloud = new Cloud(xyz))
    using (ArrayView view = cloud.GetPoints()) {
      Check.That(Same(xyz, view), "coordinates differ");
      Check.Equal(ElementType.Float64, view.Type, "type");
      Check.That(Same((double[,])view.ToRows(), view), "ToRows differs");
      Check.Equal(view.Length, view.ToArray<double>().LongLength, "length");
    }
  }

  public static void Every_kind_of_array__enters_a_cloud() {
    var flat = new double[] {1, 2, 3, 4, 5, 6};
    var kinds = new ArrayArgument[] {
        flat, new float[] {1, 2, 3, 4, 5, 6}, new double[,] {{1, 2, 3}, {4, 5, 6}}, new float[,] {{1, 2, 3}, {4, 5, 6}},
        new[] {new double[] {1, 2, 3}, new double[] {4, 5, 6}}, new int[] {1, 2, 3, 4, 5, 6},
        new byte[] {1, 2, 3, 4, 5, 6}, new long[,] {{1, 2, 3}, {4, 5, 6}},
#if JALON_SPANS
        new ReadOnlyMemory<double>(flat), new ReadOnlyMemory<float>(new float[] {0, 1, 2, 3, 4, 5, 6}, 1, 6),
        new ReadOnlySpan<double>(flat), new ReadOnlySpan<float>(new float[] {0, 1, 2, 3, 4, 5, 6}, 1, 6),
#endif
    };
    foreach (ArrayArgument kind in kinds) {
      using (var cloud = new Cloud(kind))
      using (ArrayView view = cloud.GetPoints()) {
        Check.Equal(2L, cloud.Count, "count");
        Check.Equal("1 2 3 4 5 6", string.Join(" ", view.ToDoubles()), "coordinates");
        using (var again = new Cloud(view)) Check.Equal(2L, again.Count, "from a view");
      }
    }
  }

  /// <summary>Each conversion of the public type, on what it converts.</summary>
  public static void Every_type_of_array__is_an_argument() {
    int conversions = 0;
    foreach (MethodInfo conversion in typeof(ArrayArgument).GetMethods().Where(m => m.Name == "op_Implicit")) {
      Type type = conversion.GetParameters()[0].ParameterType;
      if (!type.IsArray) continue;
      Type element = type.GetElementType();
      Array rows = type.GetArrayRank() == 2 ? Array.CreateInstance(element, 2, 3) : Array.CreateInstance(element, element.IsArray ? 2 : 6);
      if (element.IsArray) {
        for (int i = 0; i < 2; ++i) rows.SetValue(Array.CreateInstance(element.GetElementType(), 3), i);
      }
      using (var cloud = new Cloud((ArrayArgument)conversion.Invoke(null, new object[] {rows}))) Check.Equal(2L, cloud.Count, type.Name);
      ++conversions;
    }
    Check.Equal(24, conversions, "conversions");
#if JALON_SPANS
    using (var cloud = new Cloud(new double[9])) {
      Check.Equal(2L, cloud.Select(new ReadOnlySpan<long>(new long[] {0, 2})).Count, "a span of indices");
      Check.Equal(1L, cloud.Select(new ReadOnlySpan<int>(new[] {1})).Count, "a span of indices");
    }
#endif
  }

  public static void Wrong_shapes__are_refused_by_name() {
    var wrong = new ArrayArgument[] {new double[5], new double[4, 2], new[] {new double[3], new double[2]}, new double[][] {null},
                                     default(ArrayArgument)};
    foreach (ArrayArgument array in wrong) {
      ArrayArgument given = array;
      string message = Check.Throws<InvalidArgumentException>(() => new Cloud(given)).Message;
      Check.That(message.Contains("xyz"), "the message names no argument: " + message);
    }
    Check.Equal("xyz: row 0 is null", Check.Throws<InvalidArgumentException>(() => new Cloud(new double[][] {null, new double[3]})).Message, "a null row");
    Check.Equal("xyz must have rows of 3, not rows of 1", Check.Throws<InvalidArgumentException>(() => new Cloud(new double[3, 1])).Message, "a column");
    using (var cloud = new Cloud(new double[3])) {
      Check.Equal("transform must be 3 x 4 or 4 x 4, not 12 x 1",
                  Check.Throws<InvalidArgumentException>(() => cloud.Transform(new double[12, 1])).Message, "a pose as a column");
    }
    Check.Equal("xyz must have rows of 3, not 5 numbers", Check.Throws<InvalidArgumentException>(() => new Cloud(new double[5])).Message, "flat");
    using (var empty = new Cloud(new double[0, 3])) Check.Equal(0L, empty.Count, "an empty cloud");
  }

  public static void Masks__are_of_as_many_points_as_the_cloud() {
    bool[] mask = {true, false, true}, longer = {true, false, true, false};
    using (var cloud = new Cloud(new double[] {1, 2, 3, 4, 5, 6, 7, 8, 9}))
    using (Cloud some = cloud.Select(mask))
    using (Cloud none = cloud.Select(new bool[3]))
    using (CloudCropResult halves = cloud.Crop(mask)) {
      Check.Equal(2L, some.Count, "points");
      Check.Equal(7.0, some.GetPoints()[1], "the third point");
      Check.Equal(0L, none.Count, "none");
      Check.Equal(2L, halves.Inside.Count, "inside");
      Check.Equal(4.0, halves.Outside.GetPoints()[0], "outside");
      Check.Equal(4.0, cloud.Select(new int[] {1}).GetPoints()[0], "by index");
      string message = Check.Throws<InvalidArgumentException>(() => cloud.Select(longer)).Message;
      Check.That(message.Contains("4 items") && message.Contains("3 points"), message);
      Check.Throws<InvalidArgumentException>(() => cloud.Crop(new bool[1]));
      Check.Throws<InvalidArgumentException>(() => cloud.FitSphere(new bool[2]));
      Check.That(Check.Throws<InsufficientDataException>(() => cloud.FitSphere(new bool[3])).Message.Contains("mask"), "which");
      cloud.SetField("kept", mask);
      Check.Equal("1 0 1", string.Join(" ", cloud.GetFields().Doubles("kept")), "a field of flags");
      Check.Throws<InvalidArgumentException>(() => cloud.SetField("kept", longer));
    }
  }

  public static void Invalid_coordinates__are_refused_or_dropped() {
    var xyz = new double[,] {{1, 2, 3}, {double.NaN, 0, 0}, {4, 5, 6}};
    Check.Throws<InvalidArgumentException>(() => new Cloud(xyz));
    using (var cloud = new Cloud(xyz, Constants.CloudDropInvalid)) Check.Equal(2L, cloud.Count, "points kept");
  }

  public static void Views__keep_their_owner_alive() {
    double[,] xyz = Scenes.Plane(100);
    ArrayView points, values;
    using (var cloud = new Cloud(xyz)) {
      cloud.SetField("value", new double[cloud.Count]);
      points = cloud.GetPoints();
      using (Fields fields = cloud.GetFields()) values = fields["value"];
    }
    for (int i = 0; i < 20; ++i) {
      GC.Collect();
      GC.WaitForPendingFinalizers();
      using (var other = new Cloud(new double[30000])) {}
    }
    Check.That(Same(xyz, points), "the view changed when its cloud went");
    Check.Equal(0.0, values[9999], "value");
    points.Dispose();
    points.Dispose();
    Check.Throws<ObjectDisposedException>(() => points.ToArray());
    Check.Throws<ObjectDisposedException>(() => { double x = points[0]; });
    values.Dispose();
  }

  public static void Large_integers__cross_whole() {
    var large = new long[] {1L << 41, -(1L << 53) - 1, long.MaxValue};
    var unsigned = new ulong[] {1UL << 41, ulong.MaxValue, 3};
    using (var cloud = new Cloud(new double[9])) {
      cloud.SetField("large", large);
      cloud.SetField("unsigned", unsigned);
      using (Fields fields = cloud.GetFields())
      using (ArrayView a = fields["large"])
      using (ArrayView b = fields["unsigned"]) {
        Check.Equal(string.Join(" ", large), string.Join(" ", a.ToArray<long>()), "int64");
        Check.Equal(string.Join(" ", unsigned), string.Join(" ", b.ToArray<ulong>()), "uint64");
      }
    }
    using (var options = new SubsampleOptions { Seed = 1L << 45 }) Check.Equal(1L << 45, options.Seed, "a parameter");
    using (var cloud = new Cloud(new double[9])) {
      Check.Throws<InvalidArgumentException>(() => cloud.Station(-2));
      Check.Throws<InvalidArgumentException>(() => cloud.Knn(new double[3], 1L << 33));
    }
  }

  public static void More_than_2_to_the_31_elements__come_in_pieces() {
    if (!Check.Full) return;  // 10 GB of memory, and seconds
    const int kRows = (1 << 19) + 1, kColumns = 4096, kAtOnce = 1024;
    using (var builder = new CloudBuilder()) {
      builder.DeclareField("many", (int)ElementType.Uint8, kColumns);
      for (int first = 0; first < kRows; first += kAtOnce) {
        var values = new byte[Math.Min(kAtOnce, kRows - first), kColumns];
        for (int i = 0; i < values.GetLength(0); ++i) values[i, kColumns - 1] = (byte)((first + i) % 251);
        builder.AppendPoints(new double[values.GetLength(0), 3]);
        builder.AppendField("many", values);
      }
      using (Cloud cloud = builder.Seal())
      using (Fields fields = cloud.GetFields())
      using (ArrayView many = fields["many"]) {
        Check.That(many.Length > 1L << 31, "too few");
        Check.Throws<LimitException>(() => many.ToArray());
        Check.Throws<LimitException>(() => many.ToDoubles());
        Check.Equal((double)((kRows - 1) % 251), many[kRows - 1, kColumns - 1], "the last element");
        var last = new byte[kColumns];
        many.CopyTo(last, kRows - 1, 1);
        Check.Equal((byte)((kRows - 1) % 251), last[kColumns - 1], "the last element, copied");
        Check.Figure(many.Length + " elements, in pieces");
      }
    }
  }

  public static void Columns__have_rows_types_and_pieces() {
    using (var cloud = new Cloud(Scenes.Plane(30))) {
      cloud.ComputeNormals();
      using (Fields fields = cloud.GetFields())
      using (ArrayView normal = fields["normal"]) {
        Check.Equal(ElementType.Float32, normal.Type, "type");
        Check.Equal(3, normal.Components, "components");
        var piece = new float[30];
        normal.CopyTo(piece, 890, 10);
        Check.Equal((double)piece[29], normal[899, 2], "the last element");
        Check.Throws<InvalidArgumentException>(() => normal.CopyTo(piece, 895, 10));
        Check.Throws<InvalidArgumentException>(() => normal.ToArray<double>());
        Check.Throws<IndexOutOfRangeException>(() => { double x = normal[900]; });
        Check.That(fields.ToDictionary()["normal"] is float[,], "a dictionary with rows");
#if JALON_SPANS
        Check.Equal(normal[899, 2], (double)normal.AsSpan<float>()[2699], "span");
        GC.KeepAlive(normal);
#endif
      }
    }
  }

  public static void Small_results__have_their_shape() {
    using (var cloud = new Cloud(new double[,] {{0, 0, 0}, {1, 2, 3}})) {
      double[,] box = cloud.GetBounds();
      Check.Equal("0 3", box[0, 2] + " " + box[1, 2], "bounds");
      CloudCovarianceResult spread = cloud.Covariance();
      Check.Equal(1.5, spread.Centroid[2], "centroid");
      Check.Equal(9, spread.Covariance.Length, "covariance");
      var shift = new double[,] {{1, 0, 0, 10}, {0, 1, 0, 20}, {0, 0, 1, 30}, {0, 0, 0, 1}};
      using (Cloud moved = cloud.Transform(shift)) Check.Equal(33.0, moved.GetBounds()[1, 2], "moved");
    }
  }
}
