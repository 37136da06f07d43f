// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Globalization;

namespace Jalon {

/// <summary>Objects as one line of text, for ToString: nothing that takes long, nothing that follows the culture.</summary>
internal static class Described {
  internal static string About(Cloud cloud) {
    using (Fields fields = cloud.GetFields()) {
      long stations = cloud.StationCount;
      return Points(cloud.Count) + Columns(fields, "fields") + (stations == 0 ? "" : "; stations: " + stations);
    }
  }

  internal static string About(CloudBuilder builder) {
    return "";
  }

  internal static string About(Worker worker) {
    return worker.Parameters.ToJson();
  }

  internal static string About(Comparison comparison) {
    using (Fields points = comparison.GetPoints()) return Points(Rows(points)) + Columns(points, "columns");
  }

  internal static string About(Evaluation evaluation) {
    return "pairs: " + RowsOf(evaluation.GetPairs());
  }

  internal static string About(Fields fields) {
    var columns = new List<string>();
    for (long i = 0; i < fields.Count; ++i) {
      FieldsInfoResult info = fields.Info(i);
      columns.Add(info.Name + " (" + (info.Unit == "" ? "" : info.Unit + ", ") +
                  Shape(info.Count, info.Components, (ElementType)info.Type) + ")");
    }
    return string.Join("; ", columns);
  }

  internal static string About(JalonTask task) {
    return task.IsCancelled ? "cancelled" : "";
  }

  internal static string About(Model model) {
    return "parts: " + model.PartCount + "; vertices: " + RowsOf(model.GetVertices()) + "; faces: " + RowsOf(model.GetFaces());
  }

  internal static string About(ModelEvaluation evaluation) {
    return "pairs: " + RowsOf(evaluation.GetPairs());
  }

  internal static string About(NoiseLaw law) {
    return law.Json;
  }

  internal static string About(Params options) {
    return options.ToJson();
  }

  internal static string About(Registration registration) {
    return "pose " + Value(registration.GetPose());
  }

  internal static string About(Segmentation segmentation) {
    return "segments: " + RowsOf(segmentation.GetSegments()) + " in " + Points(RowsOf(segmentation.GetPoints()));
  }

  internal static string About(Adjustment adjustment) {
    Fields summary = adjustment.GetSummary();
    return "strips: " + summary.Doubles("strips")[0] + "; passes: " + summary.Doubles("passes")[0];
  }

  internal static string About(Network network) {
    Fields summary = network.GetSummary();
    return "points: " + summary.Doubles("points")[0] + "; redundancy: " + summary.Doubles("redundancy")[0];
  }

  internal static string About(Sections sections) {
    return "sections: " + RowsOf(sections.GetSummary()) + "; lines: " + RowsOf(sections.GetLines());
  }

  internal static string About(Trajectory trajectory) {
    return "epochs: " + trajectory.Count + "; axes: " + trajectory.Axes;
  }

  /// <summary>"1000 x 3 Float64".</summary>
  internal static string Shape(long count, long components, ElementType type) {
    return count + (components == 1 ? " " : " x " + components + " ") + type;
  }

  /// <summary>Names and values by turns.</summary>
  internal static string Result(string class_name, params object[] names_and_values) {
    var parts = new List<string>();
    for (int i = 0; i < names_and_values.Length; i += 2) parts.Add(names_and_values[i] + " = " + Value(names_and_values[i + 1]));
    return class_name + ": " + string.Join(", ", parts);
  }

  private static string Value(object value) {
    if (value is double) return ((double)value).ToString("R", CultureInfo.InvariantCulture);
    var numbers = value as Array;
    if (numbers == null) return Convert.ToString(value, CultureInfo.InvariantCulture);
    var texts = new List<string>();
    foreach (object number in numbers) texts.Add(Value(number));
    return "[" + string.Join(", ", texts) + "]";
  }

  private static string Points(long count) {
    return count == 1 ? "1 point" : count + " points";
  }

  private static string Columns(Fields fields, string kind) {
    return fields.Count == 0 ? "" : "; " + kind + ": " + string.Join(", ", fields.Names);
  }

  private static long RowsOf(Fields table) {
    using (table) return Rows(table);
  }

  private static long Rows(Fields table) {
    return table.Count == 0 ? 0 : table.Info(0).Count;
  }
}

}
