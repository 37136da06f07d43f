// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.function.Supplier;

/** Objects as one line of text, for toString: never an exception, nothing that takes long. */
final class Described {
  private static final String[] TYPES = {
    "", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"
  };

  private Described() {}

  static String of(Cloud cloud) {
    return line("Cloud", cloud.isClosed(), () -> {
      final long stations = cloud.stationCount();
      return points(cloud.count()) + columns(cloud.fields(), "fields") + (stations == 0 ? "" : "; stations: " + stations);
    });
  }

  static String of(CloudBuilder builder) {
    return line("CloudBuilder", builder.isClosed(), () -> "");
  }

  static String of(Comparer comparer) {
    return line("Comparer", comparer.isClosed(), () -> json(comparer.params()));
  }

  static String of(Comparison comparison) {
    return line("Comparison", comparison.isClosed(), () -> {
      try (Fields points = comparison.points()) {
        return points(rows(points)) + columns(points, "columns");
      }
    });
  }

  static String of(Evaluation evaluation) {
    return line("Evaluation", evaluation.isClosed(), () -> "pairs: " + rowsOf(evaluation.pairs()));
  }

  static String of(Fields fields) {
    return line("Fields", fields.isClosed(), () -> {
      final StringBuilder text = new StringBuilder();
      for (long i = 0; i < fields.count(); ++i) {
        final FieldsInfoResult info = fields.info(i);
        text.append(i == 0 ? "" : "; ").append(info.name()).append(" (");
        text.append(info.unit().isEmpty() ? "" : info.unit() + ", ");
        text.append(shape(info.count(), info.components(), info.type())).append(')');
      }
      return text.toString();
    });
  }

  static String of(Model model) {
    return line("Model", model.isClosed(), () -> "parts: " + model.partCount() + "; vertices: " + rowsOf(model.vertices())
        + "; faces: " + rowsOf(model.faces()));
  }

  static String of(ModelEvaluation evaluation) {
    return line("ModelEvaluation", evaluation.isClosed(), () -> "pairs: " + rowsOf(evaluation.pairs()));
  }

  static String of(Modeller modeller) {
    return line("Modeller", modeller.isClosed(), () -> json(modeller.params()));
  }

  static String of(NoiseLaw law) {
    return line("NoiseLaw", law.isClosed(), law::json);
  }

  static String of(Params params) {
    return line(params.getClass().getSimpleName(), params.isClosed(), params::toJson);
  }

  static String of(Registrar registrar) {
    return line("Registrar", registrar.isClosed(), () -> json(registrar.params()));
  }

  static String of(Registration registration) {
    return line("Registration", registration.isClosed(), () -> "pose " + java.util.Arrays.toString(registration.pose()));
  }

  static String of(Scanner scanner) {
    return line("Scanner", scanner.isClosed(), () -> json(scanner.params()));
  }

  static String of(Segmentation segmentation) {
    return line("Segmentation", segmentation.isClosed(),
        () -> "segments: " + rowsOf(segmentation.segments()) + " in " + points(rowsOf(segmentation.points())));
  }

  static String of(Segmenter segmenter) {
    return line("Segmenter", segmenter.isClosed(), () -> json(segmenter.params()));
  }

  static String of(Task task) {
    return line("Task", task.isClosed(), () -> task.isCancelled() ? "cancelled" : "");
  }

  static String of(Adjustment adjustment) {
    return line("Adjustment", adjustment.isClosed(), () -> {
      final Fields summary = adjustment.summary();
      return "strips: " + (long) summary.doubles("strips")[0] + "; passes: " + (long) summary.doubles("passes")[0];
    });
  }

  static String of(Network network) {
    return line("Network", network.isClosed(), () -> {
      final Fields summary = network.summary();
      return "points: " + (long) summary.doubles("points")[0] + "; redundancy: " + (long) summary.doubles("redundancy")[0];
    });
  }

  static String of(Sections sections) {
    return line("Sections", sections.isClosed(),
        () -> "sections: " + rowsOf(sections.summary()) + "; lines: " + rowsOf(sections.lines()));
  }

  static String of(Trajectory trajectory) {
    return line("Trajectory", trajectory.isClosed(), () -> "epochs: " + trajectory.count() + "; axes: " + trajectory.axes());
  }

  /** "float64". */
  static String type(int type) {
    return TYPES[type];
  }

  /** "1000 x 3 float64". */
  static String shape(long count, long components, int type) {
    return count + (components == 1 ? " " : " x " + components + " ") + TYPES[type];
  }

  /** name and value by turns. */
  static String result(String className, Object... namesAndValues) {
    final StringBuilder text = new StringBuilder(className + ": ");
    for (int i = 0; i < namesAndValues.length; i += 2) {
      text.append(i == 0 ? "" : ", ").append(namesAndValues[i]).append(" = ").append(namesAndValues[i + 1]);
    }
    return text.toString();
  }

  private static String line(String className, boolean closed, Supplier<String> about) {
    if (!closed) {
      try {
        final String text = about.get();
        return text.isEmpty() ? className : className + ": " + text;
      } catch (ClosedException byAnotherThread) {
        return className + " (closed)";
      } catch (JalonException failure) {
        return className + " (" + failure.getMessage() + ")";
      }
    }
    return className + " (closed)";
  }

  private static String points(long count) {
    return count == 1 ? "1 point" : count + " points";
  }

  private static String json(Params params) {
    try (params) {
      return params.toJson();
    }
  }

  private static String columns(Fields fields, String kind) {
    try (fields) {
      return fields.count() == 0 ? "" : "; " + kind + ": " + String.join(", ", fields.names());
    }
  }

  private static long rowsOf(Fields table) {
    try (table) {
      return rows(table);
    }
  }

  private static long rows(Fields table) {
    return table.count() == 0 ? 0 : table.info(0).count();
  }
}
