// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.nio.ByteBuffer;
import java.util.Map;

/** Objects as bytes and back, and copies. */
final class ObjectBytes {
  private ObjectBytes() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("bytes__bring_back_a_cloud", ObjectBytes::cloud);
    all.put("bytes__bring_back_parameters_workers_and_results", ObjectBytes::others);
    all.put("bytes__that_are_damaged_are_refused", ObjectBytes::damaged);
    all.put("copies__are_objects_of_their_own", ObjectBytes::copies);
  }

  private static Cloud made() {
    final Cloud cloud = Cloud.create(Behaviours.dome(40), 0);
    cloud.setField("count", new long[1600], "points", "how many");
    cloud.setCrs("EPSG:2154");
    return cloud;
  }

  private static void expectSame(byte[] wanted, byte[] got) {
    expect(java.util.Arrays.equals(wanted, got), "other bytes: " + wanted.length + " and " + got.length);
  }

  private static void cloud() {
    try (Cloud cloud = made()) {
      final byte[] bytes = cloud.toBytes();
      final ByteBuffer direct = ByteBuffer.allocateDirect(bytes.length).put(bytes);
      direct.flip();
      try (Cloud back = Cloud.fromBytes(bytes); Cloud again = Cloud.fromBytes(direct); Array points = back.points();
          Array own = cloud.points()) {
        same("EPSG:2154", back.crs());
        expect(java.util.Arrays.equals(own.toDoubles(), points.toDoubles()), "other points");
        expectSame(bytes, back.toBytes());
        expectSame(bytes, again.toBytes());
      }
    }
  }

  private static void others() {
    try (Cloud cloud = made(); Segmenter segmenter = Segmenter.create("region_growing").set("min_points", 20);
        Segmenter back = Segmenter.fromBytes(segmenter.toBytes()); Params params = back.params()) {
      same(20L, params.getInt64("min_points"));
      try (Params own = Params.fromBytes(params.toBytes()); Segmentation made = segmenter.run(cloud);
          Segmentation segmentation = Segmentation.fromBytes(made.toBytes())) {
        same(params.toJson(), own.toJson());
        expectSame(made.toBytes(), segmentation.toBytes());
      }
    }
  }

  private static void damaged() {
    try (Cloud cloud = made()) {
      final byte[] bytes = cloud.toBytes();
      thrown(InvalidArgumentException.class, () -> Model.fromBytes(bytes));
      thrown(InvalidArgumentException.class, () -> Cloud.fromBytes((byte[]) null));
      thrown(InvalidArgumentException.class, () -> Cloud.fromBytes(Rows.of(new double[3])));
      thrown(FormatException.class, () -> Cloud.fromBytes(new byte[0]));
      bytes[100] ^= 1;
      final String message = thrown(FormatException.class, () -> Cloud.fromBytes(bytes)).getMessage();
      expect(message.contains("checksum"), message);
    }
  }

  private static void copies() {
    final Cloud cloud = made();
    try (Cloud copy = cloud.copy()) {
      copy.setCrs("");
      same("EPSG:2154", cloud.crs());
      cloud.close();
      same(1600L, copy.count());
    }
    try (Scanner scanner = Scanner.create("sample").setSeed(9); Scanner copy = scanner.copy().setSeed(10);
        Params params = scanner.params(); Params others = copy.params()) {
      same(9L, params.getInt64("seed"));
      same(10L, others.getInt64("seed"));
    }
  }
}
