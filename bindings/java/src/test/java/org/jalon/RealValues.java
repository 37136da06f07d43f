// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.lang.reflect.Executable;
import java.lang.reflect.Parameter;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.nio.ShortBuffer;
import java.util.Map;

/** A real value for each parameter, by its name and type. */
final class RealValues {
  private static final double[] CORNERS = {0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 2};
  private static final double[] SQUARE = {0, 0, 1, 0, 1, 1, 0, 1};
  private static final double[] THREE = {10, 20, 30};
  private static final Map<String, double[]> NUMBERS = Map.ofEntries(
      Map.entry("xyz", CORNERS), Map.entry("points", CORNERS), Map.entry("x", THREE), Map.entry("y", THREE), Map.entry("z", THREE),
      Map.entry("queries", new double[] {5, 0, 2, 10, 0, 5}), Map.entry("vertices", CORNERS),
      Map.entry("triangles", new double[] {0, 1, 2, 0, 1, 3}), Map.entry("face_ids", new double[] {1, 2}),
      Map.entry("alignment", new double[] {0, 0, 0, 10, 0, 0}),
      Map.entry("polygon_uv", new double[] {-50, -50, 50, -50, 50, 50, -50, 50}),
      Map.entry("places", Survey.BALL), Map.entry("values", new double[] {0.001, 0.002, 0.003}),
      Map.entry("numbers", THREE),
      Map.entry("probabilities", new double[] {0.1, 0.5, 0.9}), Map.entry("automatic_m2", THREE), Map.entry("reference_m2", THREE),
      Map.entry("intersection_m2", new double[] {9, 19, 29}), Map.entry("automatic_uv", SQUARE), Map.entry("reference_uv", SQUARE),
      Map.entry("automatic_rings", new double[] {4}), Map.entry("reference_rings", new double[] {4}),
      Map.entry("automatic_xyz", CORNERS), Map.entry("reference_xyz", CORNERS), Map.entry("ranges_m", THREE),
      Map.entry("vertical_rad", new double[] {0, 0.1, 0.2}), Map.entry("incidence_rad", new double[] {0, 0.1, 0.2}),
      Map.entry("measured_m", new double[] {10.01, 20.01, 30.02}), Map.entry("known_m", THREE),
      Map.entry("wavelengths_m", new double[] {100, 10, 1}), Map.entry("remainders_m", new double[] {37.25, 7.25, 0.25}),
      Map.entry("poses", Survey.POSES),
      Map.entry("indices", new double[] {0, 1, 2, 3, 40, 50, 60, 70}), Map.entry("seeds", new double[] {0, 1}),
      Map.entry("box", new double[] {-5, -10, -1, 12, 10, 20}), Map.entry("edges", new double[] {1, 2, 3}),
      Map.entry("foot", new double[] {5, 0, -1}), Map.entry("top", new double[] {5, 0, 20}), Map.entry("direction", new double[] {0, 0, 1}),
      Map.entry("thetas_rad", new double[] {0.1, 2, 3}), Map.entry("phis_rad", new double[] {1.5, 1.6, 1.7}),
      Map.entry("times_s", THREE), Map.entry("positions_m", Survey.DRIVE), Map.entry("attitudes_rad", new double[9]),
      Map.entry("position_sigmas_m", Survey.SIGMAS), Map.entry("velocity_sigmas_m_s", Survey.SIGMAS),
      Map.entry("attitude_sigmas_rad", Survey.SIGMAS),
      Map.entry("covariance", new double[] {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6}));
  private static final Map<String, Integer> COLUMNS = Map.ofEntries(Map.entry("poses", 12), Map.entry("alignment", 3), Map.entry("polygon_uv", 2),
      Map.entry("automatic_uv", 2), Map.entry("reference_uv", 2), Map.entry("data", 1), Map.entry("probabilities", 1),
      Map.entry("times_s", 1), Map.entry("thetas_rad", 1), Map.entry("phis_rad", 1), Map.entry("positions_m", 3), Map.entry("attitudes_rad", 3), Map.entry("position_sigmas_m", 3),
      Map.entry("velocity_sigmas_m_s", 3), Map.entry("attitude_sigmas_rad", 3));
  private static final Map<String, String> TEXTS = Map.ofEntries(
      Map.entry("field", "deviation"), Map.entry("other", "slope"), Map.entry("label_field", "label"), Map.entry("class_field", "label"),
      Map.entry("reference_field", "truth"), Map.entry("gradient_field", "slope"), Map.entry("crs", "EPSG:2154"), Map.entry("unit", "m"),
      Map.entry("meaning", "of the test"), Map.entry("operation", "normals"), Map.entry("notes_json", "{\"by\": \"the test\"}"),
      Map.entry("part_class", "wall"), Map.entry("name", "mine"), Map.entry("value", "quadric"), Map.entry("json", "{\"k\": 12}"),
      Map.entry("NoiseLaw.fromJson.json", "{\"law\": \"gauss\", \"mean\": 0, \"sigma\": 0.003}"),
      Map.entry("Cloud.removeField.name", "slope"), Map.entry("Fields.copy.name", "deviation"), Map.entry("Fields.view.name", "deviation"),
      Map.entry("Fields.doubles.name", "deviation"), Map.entry("double.name", "radius_m"), Map.entry("long.name", "k"),
      Map.entry("boolean.name", "curvature"), Map.entry("String.name", "method"), Map.entry("double[].name", "viewpoint"),
      Map.entry("svg", ".svg"), Map.entry("Cloud.read.path", "scan.las"), Map.entry("Model.read.path", "model.obj"),
      Map.entry("Cloud.convert.source", "scan.las"), Map.entry("Cloud.convert.target", "converted.xyz"),
      Map.entry("Cloud.write.path", "written.las"), Map.entry("Model.write.path", "written.obj"),
      Map.entry("Cloud.writeDepthMap.path", "depth.png"), Map.entry("Sections.write.path", "sections.dxf"), Map.entry("Comparer.readM3c2File.path", "m3c2.txt"),
      Map.entry("Segmentation.writePrimitives.path", "primitives.txt"), Map.entry("Jalon.reportWriteHtml.path", "report.html"),
      Map.entry("Jalon.reportWriteJson.path", "report.json"), Map.entry("Jalon.reportWriteComparison.path", "comparison.html"),
      Map.entry("Jalon.reportWriteClearance.path", "clearance.html"),
      Map.entry("Jalon.reportWriteRegistration.path", "registration.html"),
      Map.entry("Jalon.reportWriteOrthoimage.path", "orthoimage.png"),
      Map.entry("Jalon.reportWriteAdjustment.path", "adjustment.html"),
      Map.entry("Network.adjust.points", Survey.NAILS), Map.entry("Network.adjust.observations", Survey.SIGHTS),
      Map.entry("Trajectory.read.path", "drive.txt"), Map.entry("Trajectory.write.path", "driven.txt"),
      Map.entry("Jalon.sceneWriteTruth.path", "truth.json"));
  private static final Map<String, Double> SCALARS = Map.ofEntries(
      Map.entry("k", 4.0), Map.entry("knn.level", -1.0), Map.entry("level", 6.0), Map.entry("code", 0.0), Map.entry("reach", 1.0),
      Map.entry("w_min", -100.0), Map.entry("w_max", 100.0), Map.entry("radius_m", 0.5), Map.entry("radiusM", 0.5),
      Map.entry("lengthM", 2.0), Map.entry("spacing_s", 4.0), Map.entry("spacingS", 4.0), Map.entry("tolerance_m", 0.01), Map.entry("split.value", 1.0), Map.entry("value", 12.0),
      Map.entry("a", 1.0), Map.entry("b", 0.0), Map.entry("c", 1.0), Map.entry("type", 10.0), Map.entry("components", 1.0),
      Map.entry("label", 1.0), Map.entry("bins", 10.0), Map.entry("primitive", 1.0), Map.entry("threads", 1.0), Map.entry("bytes", 1e9), Map.entry("status", -1.0),
      Map.entry("elements", 3.0), Map.entry("items", 1.0), Map.entry("part", -1.0), Map.entry("other_part", -1.0));

  private RealValues() {}

  static Object of(Executable call, Parameter parameter, Object self) {
    final String name = parameter.getName();
    final String where = call.getDeclaringClass().getSimpleName() + "." + call.getName();
    final Class<?> type = parameter.getType();
    if (type == String.class) {
      final String of = self instanceof Params && name.equals("name") ? typeOf(call) : where;
      return EveryCall.text(of, name, TEXTS);
    }
    if (type == boolean[].class) {
      final boolean[] mask = new boolean[self instanceof Cloud ? (int) ((Cloud) self).count() : 4];
      java.util.Arrays.fill(mask, true);
      return mask;
    }
    if (type == boolean.class) {
      return true;
    }
    if (type == double.class || type == long.class || type == int.class) {
      if (where.equals("Model.removeCopy")) {
        return (long) Survey.get().copy;
      }
      final double value = SCALARS.getOrDefault(call.getName() + "." + name, SCALARS.getOrDefault(name, 0.0));
      return type == double.class ? (Object) value : type == long.class ? (Object) (long) value : (Object) (int) value;
    }
    if (name.equals("bytes")) {
      return octets(type, EveryCall.bytes(call));
    }
    if (type.isArray() || java.nio.Buffer.class.isAssignableFrom(type) || type == Rows.class || type == Array.class) {
      return array(type, name, numbers(where, name, self));
    }
    return EveryCall.object(type, where, name);
  }

  /** Of the parameter that set(name, double), getDouble(name) and the like are about. */
  private static String typeOf(Executable call) {
    final String type = call.getParameterCount() == 2 ? call.getParameterTypes()[1].getSimpleName()
        : ((java.lang.reflect.Method) call).getReturnType().getSimpleName();
    return type.equals("Rows") || type.endsWith("Buffer") || type.equals("Array") || type.equals("float[]") ? "double[]" : type;
  }

  private static double[] numbers(String where, String name, Object self) {
    if (name.equals("data")) {
      return new double[self instanceof Cloud ? (int) ((Cloud) self).count() : 4];
    }
    if (name.equals("picks")) {
      return Survey.get().onWall;
    }
    if (where.equals("Targets.add") && name.equals("xyz") || where.equals("Gauge.addHull") && name.equals("frame")) {
      return name.equals("xyz") ? Survey.BALL : Survey.IDENTITY;
    }
    return NUMBERS.getOrDefault(name, Survey.IDENTITY);
  }

  /** The numbers as this type of array. */
  static Object array(Class<?> type, String name, double[] numbers) {
    final int columns = COLUMNS.getOrDefault(name, name.equals("x") || name.equals("y") || name.equals("z")
        || name.endsWith("_m") || name.endsWith("_m2") || name.endsWith("_rad") || name.equals("values") || numbers.length % 3 != 0
        || name.equals("indices") || name.equals("seeds") ? 1 : 3);
    final float[] floats = new float[numbers.length];
    final long[] longs = new long[numbers.length];
    final int[] ints = new int[numbers.length];
    for (int i = 0; i < numbers.length; ++i) {
      floats[i] = (float) numbers[i];
      longs[i] = (long) numbers[i];
      ints[i] = (int) numbers[i];
    }
    if (type == double[].class) {
      return numbers;
    } else if (type == float[].class) {
      return floats;
    } else if (type == long[].class) {
      return longs;
    } else if (type == int[].class) {
      return ints;
    } else if (type == short[].class) {
      return new short[numbers.length];
    } else if (type == byte[].class) {
      return new byte[numbers.length];
    } else if (type == double[][].class) {
      final double[][] rows = new double[numbers.length / columns][];
      for (int i = 0; i < rows.length; ++i) {
        rows[i] = java.util.Arrays.copyOfRange(numbers, i * columns, (i + 1) * columns);
      }
      return rows;
    } else if (type == DoubleBuffer.class) {
      return DoubleBuffer.wrap(numbers);
    } else if (type == FloatBuffer.class) {
      return FloatBuffer.wrap(floats);
    } else if (type == LongBuffer.class) {
      return LongBuffer.wrap(longs);
    } else if (type == IntBuffer.class) {
      return IntBuffer.wrap(ints);
    } else if (type == ShortBuffer.class) {
      return ShortBuffer.allocate(numbers.length);
    } else if (type == ByteBuffer.class) {
      return ByteBuffer.allocate(numbers.length);
    }
    return type == Rows.class ? Rows.of(numbers) : column(numbers, columns);
  }

  private static Object octets(Class<?> type, byte[] bytes) {
    return type == byte[].class ? bytes : type == ByteBuffer.class ? ByteBuffer.wrap(bytes)
        : type == Rows.class ? Rows.of(bytes) : column(Rows.of(bytes), bytes.length);
  }

  private static Array column(double[] numbers, int columns) {
    return column(Rows.of(numbers).by(columns), numbers.length / columns);
  }

  /** An array that the library gave. */
  private static Array column(Rows values, int count) {
    try (Cloud cloud = Cloud.create(new double[count * 3])) {
      cloud.setField("numbers", values);
      try (Fields fields = cloud.fields()) {
        return fields.view("numbers");
      }
    }
  }
}
