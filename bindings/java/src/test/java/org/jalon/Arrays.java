// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.ReadOnlyBufferException;
import java.util.Map;

/** Numbers in and out, texts, parameters. */
final class Arrays {
  private static final double[] XYZ = {1, 2, 3, 4, 5, 6, 1e6 + 0.001, 5e6 + 0.002, 7};

  private Arrays() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("arrays__every_kind_of_numbers_makes_the_same_cloud", Arrays::everyKind);
    all.put("arrays__views_are_read_only_and_outlive_their_cloud", Arrays::views);
    all.put("arrays__pieces_of_an_array", Arrays::pieces);
    all.put("arrays__fields_keep_type_and_components", Arrays::fields);
    all.put("arrays__masks_are_of_as_many_points_as_the_cloud", Arrays::masks);
    all.put("arrays__values_above_2_to_the_40", Arrays::large);
    all.put("arrays__what_is_no_array_is_refused", Arrays::refused);
    all.put("texts__utf8_in_names_and_files", Arrays::texts);
    all.put("params__by_name_typed_and_in_classes", Arrays::params);
    all.put("results__are_values", Arrays::results);
    all.put("lists__targets_and_gauges", Arrays::lists);
    if ("1".equals(System.getenv("JALON_FULL"))) { // 10 GB of memory, and seconds
      all.put("arrays__more_than_2_to_the_31_elements", Arrays::beyondOneBuffer);
    }
  }

  private static void check(Cloud made) {
    try (Cloud cloud = made; Array points = cloud.points()) {
      same(3L, cloud.count());
      same(3, points.components());
      same(DoubleBuffer.wrap(XYZ), points.doubles());
      expect(java.util.Arrays.equals(XYZ, points.toDoubles()), "the copy differs");
    }
  }

  private static void everyKind() {
    check(Cloud.create(XYZ));
    check(Cloud.create(DoubleBuffer.wrap(XYZ)));
    check(Cloud.create(new double[][] {{1, 2, 3}, {4, 5, 6}, {1e6 + 0.001, 5e6 + 0.002, 7}}));
    for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
      final DoubleBuffer longer = ByteBuffer.allocateDirect(8 * 12).order(order).asDoubleBuffer();
      longer.position(2);
      longer.put(XYZ).limit(11).position(2);
      check(Cloud.create(longer));
      same(2, longer.position());
      check(Cloud.create(Rows.of(longer).by(3), 0));
    }
    try (Cloud cloud = Cloud.create(XYZ); Array points = cloud.points()) {
      check(Cloud.create(points));
    }
    final double[][] axes = new double[3][3];
    for (int i = 0; i < XYZ.length; ++i) {
      axes[i % 3][i / 3] = XYZ[i];
    }
    check(Cloud.createColumns(axes[0], axes[1], axes[2]));
    check(Cloud.createColumns(Rows.of(axes[0]), Rows.of(DoubleBuffer.wrap(axes[1])), Rows.of(axes[2])));
    try (Cloud floats = Cloud.create(new float[] {1, 2, 3.5f}); Cloud ints = Cloud.create(Rows.of(new int[] {1, 2, 3}));
        Cloud none = Cloud.create(new double[0])) {
      same(3.5, floats.points().doubles().get(2));
      same(2.0, ints.points().doubles().get(1));
      same(0L, none.count());
    }
  }

  private static void views() throws Exception {
    final DoubleBuffer view;
    try (Cloud cloud = Cloud.create(Behaviours.dome(200), 0); Array points = cloud.points()) {
      view = points.doubles();
    }
    final double last = -0.02 * 2 * 1.99 * 1.99;
    for (int i = 0; i < 5; ++i) {
      System.gc();
      Thread.sleep(5);
      expect(Math.abs(view.get(view.limit() - 1) - last) < 1e-5, "the memory of the view has changed");
    }
    expect(view.isDirect() && view.isReadOnly() && view.order() == ByteOrder.nativeOrder(), "a direct read-only view");
    thrown(ReadOnlyBufferException.class, () -> view.put(0, 1));
  }

  private static void pieces() throws Exception {
    try (Cloud cloud = Cloud.create(XYZ, 0); Array points = cloud.points()) {
      same(4.0, points.bytes(1, 2).getDouble(0));
      same(48, points.bytes(1, 2).remaining());
      thrown(IndexOutOfBoundsException.class, () -> points.bytes(2, 2));
      thrown(InvalidArgumentException.class, points::floats);
      final AutoCloseable early = points;
      early.close();
      thrown(ClosedException.class, points::doubles);
    }
  }

  private static void fields() {
    try (Cloud cloud = Cloud.create(XYZ)) {
      cloud.setField("class", new byte[] {1, 2, (byte) 200});
      cloud.setField("normal", Rows.of(new float[] {0, 0, 1, 0, 1, 0, 1, 0, 0}).by(3), "1", "normal");
      cloud.setField("time", new long[] {1L << 40, -5, Long.MAX_VALUE}, "s");
      cloud.setField("shift", new double[][] {{1, 2}, {3, 4}, {5, 6}}, "m");
      try (Fields fields = cloud.fields(); Array normal = fields.view("normal"); Array time = fields.view("time")) {
        same(3, normal.components());
        same(1f, normal.floats().get(4));
        same(1L << 40, time.longs().get(0));
        same(Long.MAX_VALUE, time.longs().get(2));
        same(200.0, fields.doubles("class")[2]);
        same(6.0, fields.doubles("shift")[5]);
        same(java.util.List.of("class", "normal", "time", "shift"), fields.names());
        expect(thrown(NotFoundException.class, () -> fields.view("none")).getMessage().contains("normal"), "no names");
      }
    }
  }

  private static void masks() {
    final boolean[] mask = {true, false, true};
    try (Cloud cloud = Cloud.create(XYZ); Cloud some = cloud.select(mask); CloudCropResult halves = cloud.crop(mask);
        Cloud none = cloud.select(new boolean[3])) {
      same(2L, some.count());
      same(XYZ[6], some.points().doubles().get(3));
      same(0L, none.count());
      same(2L, halves.inside().count());
      same(4.0, halves.outside().points().doubles().get(0));
      same(1L, cloud.select(new int[] {1}).count());
      final boolean[] longer = {true, false, true, false};
      final String message = thrown(InvalidArgumentException.class, () -> cloud.select(longer)).getMessage();
      expect(message.contains("4 items") && message.contains("3 points"), message);
      thrown(InvalidArgumentException.class, () -> cloud.crop(new boolean[1]));
      thrown(InvalidArgumentException.class, () -> cloud.fitSphere(new boolean[2]));
      expect(thrown(InsufficientDataException.class, () -> cloud.fitSphere(new boolean[3])).getMessage().contains("mask"), "which");
      cloud.setField("kept", mask);
      same(DoubleBuffer.wrap(new double[] {1, 0, 1}), DoubleBuffer.wrap(cloud.fields().doubles("kept")));
      thrown(InvalidArgumentException.class, () -> cloud.setField("kept", longer));
    }
  }

  private static void large() {
    try (ComponentsParams options = new ComponentsParams().setMinPoints(1L << 41)) {
      same(1L << 41, options.getInt64("min_points"));
    }
    same(-1L, Jalon.NO_POINT);
    try (Cloud cloud = Cloud.create(XYZ, 0)) {
      thrown(InvalidArgumentException.class, () -> cloud.knn(XYZ, 1L << 33));
      expect(thrown(InvalidArgumentException.class, () -> cloud.station(1L << 40)).getMessage().contains("1099511627776"), "which");
    }
  }

  private static void beyondOneBuffer() {
    final int rows = (1 << 19) + 1;
    final int columns = 4096;
    final int atOnce = 1024;
    final byte[] values = new byte[atOnce * columns];
    for (int i = 0; i < values.length; ++i) {
      values[i] = (byte) (i % columns % 251);
    }
    try (CloudBuilder builder = CloudBuilder.create(0)) {
      builder.declareField("many", Jalon.UINT8, columns, "", "");
      for (int first = 0; first < rows; first += atOnce) {
        final int items = Math.min(atOnce, rows - first);
        builder.appendPoints(new double[3 * items]);
        builder.appendField("many", Rows.of(java.util.Arrays.copyOf(values, items * columns)).by(columns));
      }
      try (Cloud cloud = builder.seal(); Fields fields = cloud.fields(); Array many = fields.view("many")) {
        expect(many.count() * many.components() > 1L << 31, "too few");
        thrown(LimitException.class, many::bytes);
        thrown(LimitException.class, many::toDoubles);
        final ByteBuffer last = many.bytes(rows - 1, 1);
        same(columns, last.remaining());
        same(values[columns - 1], last.get(columns - 1));
        System.out.println("FIGURE java: " + many.count() * many.components() + " elements, in pieces");
      }
    }
  }

  private static void refused() {
    same("xyz must have rows of 3, not 2 numbers", thrown(InvalidArgumentException.class, () -> Cloud.create(new double[] {1, 2}, 0)).getMessage());
    same("row 1 is null", thrown(InvalidArgumentException.class, () -> Cloud.create(new double[][] {{1, 2, 3}, null})).getMessage());
    same("row 0 is null", thrown(InvalidArgumentException.class, () -> Cloud.create(new double[][] {null})).getMessage());
    try (Cloud cloud = Cloud.create(XYZ); Array points = cloud.points()) {
      same("indices must hold whole numbers from 0 to 2^64 - 1, not -1",
          thrown(InvalidArgumentException.class, () -> cloud.select(new long[] {2, -1})).getMessage());
      same("the elements are of type float64, not float: toDoubles() converts",
          thrown(InvalidArgumentException.class, points::floats).getMessage());
    }
    thrown(InvalidArgumentException.class, () -> Cloud.create(new double[][] {{1, 2, 3}, {1, 2}}, 0));
    // Rows of one number are no points, however many there are.
    same("xyz must have rows of 3, not rows of 1",
        thrown(InvalidArgumentException.class, () -> Cloud.create(new double[3][1])).getMessage());
    thrown(InvalidArgumentException.class, () -> Cloud.create(new double[] {1, 2, Double.NaN}, 0));
    thrown(InvalidArgumentException.class, () -> Rows.of(new double[4]).by(3));
  }

  private static void texts() throws Exception {
    final String name = "façade_漢_😀";
    final java.nio.file.Path folder = java.nio.file.Files.createTempDirectory(null);
    final String path = folder + "/" + name + ".las";
    try (Cloud cloud = Cloud.create(XYZ, 0)) {
      cloud.setCrs(name);
      same(name, cloud.crs());
      cloud.setStation(name, null);
      same(name, cloud.station(0).name());
      expect(!cloud.station(0).hasPose(), "a pose from nowhere");
      cloud.write(path);
    }
    try (Cloud back = Cloud.read(path)) {
      same(3L, back.count());
    }
    // The name as the system sees it: by the bytes, whatever this virtual machine takes the names of files for.
    try (java.util.stream.Stream<java.nio.file.Path> files = java.nio.file.Files.list(folder)) {
      same(1L, files.count());
    }
    same(0, new ProcessBuilder("rm", "-r", folder.toString()).start().waitFor());
    thrown(InvalidArgumentException.class, () -> Cloud.read("a\0b"));
    expect(thrown(NotFoundException.class, () -> Cloud.read("/no/" + name + ".las")).getMessage().contains(name), "the message");
  }

  private static void params() {
    try (Segmenter segmenter = Segmenter.create("ransac"); Params params = segmenter.params()) {
      segmenter.set("distance_tolerance_m", 0.025).set("min_points", 77);
      same(0.025, params.getDouble("distance_tolerance_m"));
      segmenter.setDistanceToleranceM(0.03);
      same(0.03, params.getDouble("distance_tolerance_m"));
      expect(thrown(NotFoundException.class, () -> segmenter.set("distance", 1)).getMessage().contains("distance"), "which");
      thrown(InvalidArgumentException.class, () -> segmenter.set("distance_tolerance_m", -1));
      params.reset();
      expect(params.toJson().contains("distance_tolerance_m"), "JSON");
    }
    try (NormalsParams options = new NormalsParams().setK(20).setMethod("quadric").setViewpoint(new double[] {1, 2, 3})) {
      same("quadric", options.getString("method"));
      same(3.0, options.getDoubles("viewpoint")[2]);
      same(20L, options.getInt64("k"));
    }
  }

  private static void results() throws Exception {
    try (Cloud cloud = Cloud.create(XYZ, 0);
        CloudCropBoxResult halves = cloud.cropBox(new double[] {0, 0, 0, 2, 3, 4})) {
      same(1L, halves.inside().count());
      same(2L, halves.outside().count());
      final AutoCloseable early = halves;
      early.close();
      thrown(ClosedException.class, () -> halves.inside().count());
      same(6, cloud.bounds().length);
    }
  }

  private static void lists() {
    final double[] turned = {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7};
    final Targets there = new Targets();
    final Targets here = new Targets();
    final double[][] corners = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {0, 0, 2}};
    for (int i = 0; i < corners.length; ++i) {
      final double[] p = corners[i];
      here.add("T" + i, p);
      there.add("T" + i, new double[] {5 - p[1], 6 + p[0], 7 + p[2]});
    }
    try (Registrar registrar = Registrar.create("targets"); Registration found = registrar.runTargets(there, here)) {
      final double[] pose = found.pose();
      for (int i = 0; i < 12; ++i) {
        expect(Math.abs(pose[i] - turned[i]) < 1e-9, "pose[" + i + "] = " + pose[i]);
      }
    }
    final Gauge gauge = new Gauge().addBox(new double[] {1, 2, 3}).addSphere(0.5, turned);
    same(2, gauge.count());
    thrown(InvalidArgumentException.class, () -> gauge.addBox(new double[] {1}));
    same(2, gauge.count());
    try (Cloud a = Cloud.create(XYZ, 0); Cloud b = Cloud.create(XYZ, 0)) {
      Cloud.shareOctree(java.util.List.of(a, b));
      same(a.octreeCube().edgeM(), b.octreeCube().edgeM());
    }
  }
}
