// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Jalon;

/// <summary>A real value for each parameter, by its name and type.</summary>
static class RealValues {
  static readonly double[] corners = {0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 2}, square = {0, 0, 1, 0, 1, 1, 0, 1}, three = {10, 20, 30};

  static readonly Dictionary<string, ArrayArgument> arrays = new Dictionary<string, ArrayArgument> {
      {"xyz", corners}, {"points", corners}, {"x", three}, {"y", three}, {"z", three}, {"queries", new double[] {5, 0, 2, 10, 0, 5}},
      {"vertices", corners}, {"triangles", new[] {0, 1, 2, 0, 1, 3}}, {"faceIds", new[] {1, 2}},
      {"alignment", new double[] {0, 0, 0, 10, 0, 0}}, {"polygonUv", new double[] {-50, -50, 50, -50, 50, 50, -50, 50}}, {"picks", Survey.OnWall}, {"places", Survey.Ball},
      {"values", new[] {0.001, 0.002, 0.003}}, {"probabilities", new[] {0.1, 0.5, 0.9}}, {"automaticM2", three}, {"referenceM2", three},
      {"intersectionM2", new double[] {9, 19, 29}}, {"automaticUv", square}, {"referenceUv", square}, {"automaticRings", new[] {4}},
      {"referenceRings", new[] {4}}, {"automaticXyz", corners}, {"referenceXyz", corners}, {"rangesM", three},
      {"verticalRad", new[] {0, 0.1, 0.2}}, {"incidenceRad", new[] {0, 0.1, 0.2}}, {"measuredM", new[] {10.01, 20.01, 30.02}},
      {"knownM", three}, {"wavelengthsM", new double[] {100, 10, 1}}, {"remaindersM", new[] {37.25, 7.25, 0.25}},
      {"poses", Survey.Poses},
      {"indices", new[] {0, 1, 2, 3, 40, 50, 60, 70}}, {"seeds", new[] {0, 1}}, {"box", new double[,] {{-5, -10, -1}, {12, 10, 20}}},
      {"size", new double[] {1, 2, 3}}, {"foot", new double[] {5, 0, -1}}, {"top", new double[] {5, 0, 20}},
      {"timesS", three}, {"thetasRad", new double[] {0.1, 2, 3}}, {"phisRad", new double[] {1.5, 1.6, 1.7}},
       {"positionsM", Survey.Path3}, {"attitudesRad", new double[3, 3]},
      {"positionSigmasM", Survey.Sigmas}, {"velocitySigmasMS", Survey.Sigmas}, {"attitudeSigmasRad", Survey.Sigmas},
      {"direction", new double[] {0, 0, 1}}, {"covariance", new[,] {{1e-6, 0, 0}, {0, 1e-6, 0}, {0, 0, 1e-6}}}};

  static readonly Dictionary<string, string> texts = new Dictionary<string, string> {
      {"field", "deviation"}, {"other", "slope"}, {"labelField", "label"}, {"classField", "label"}, {"referenceField", "truth"},
      {"gradientField", "slope"}, {"set_Crs", "EPSG:2154"}, {"crs", "EPSG:2154"}, {"unit", "m"}, {"meaning", "of the test"},
      {"operation", "normals"}, {"notesJson", "{\"by\": \"the test\"}"}, {"partClass", "wall"}, {"name", "mine"}, {"value", "quadric"},
      {"FromJson.json", "{\"k\": 12}"}, {"NoiseLaw.FromJson.json", "{\"law\": \"gauss\", \"mean\": 0, \"sigma\": 0.003}"},
      {"RemoveField.name", "slope"}, {"Fields.Copy.name", "deviation"}, {"Fields.View.name", "deviation"},
      {"Fields.get_Item.name", "deviation"}, {"Fields.Doubles.name", "deviation"}, {"Double.name", "radius_m"}, {"Int64.name", "k"},
      {"Boolean.name", "curvature"}, {"String.name", "method"}, {"Double[].name", "viewpoint"}, {"Object.name", "k"},
      {"ArrayArgument.name", "viewpoint"},
      {"Cloud.Read.path", "scan.las"}, {"Model.Read.path", "model.obj"}, {"Cloud.Write.path", "written.las"},
      {"Cloud.Convert.source", "scan.las"}, {"Cloud.Convert.target", "converted.xyz"},
      {"Model.Write.path", "written.obj"}, {"Cloud.WriteDepthMap.path", "depth.png"}, {"Sections.Write.path", "sections.dxf"}, {"Comparer.ReadM3c2File.path", "m3c2.txt"},
      {"Segmentation.WritePrimitives.path", "primitives.txt"}, {"Library.ReportWriteHtml.path", "report.html"},
      {"Library.ReportWriteJson.path", "report.json"}, {"Library.ReportWriteComparison.path", "comparison.html"},
      {"Library.ReportWriteClearance.path", "clearance.html"},
      {"Library.ReportWriteRegistration.path", "registration.html"},
      {"Library.ReportWriteOrthoimage.path", "orthoimage.png"},
      {"Library.ReportWriteAdjustment.path", "adjustment.html"},
      {"Network.Adjust.points", Survey.Nails}, {"Network.Adjust.observations", Survey.Sights},
      {"Trajectory.Read.path", "drive.txt"}, {"Trajectory.Write.path", "driven.txt"},
      {"Library.SceneWriteTruth.path", "truth.json"}};

  static readonly Dictionary<string, double> scalars = new Dictionary<string, double> {
      {"k", 4}, {"Knn.level", -1}, {"level", 6}, {"reach", 1}, {"wMin", -100}, {"wMax", 100}, {"radiusM", 0.5}, {"lengthM", 2}, {"spacingS", 4},
      {"toleranceM", 0.01}, {"Split.value", 1}, {"value", 12}, {"a", 1}, {"c", 1}, {"type", 10}, {"components", 1}, {"label", 1}, {"bins", 10},
      {"primitive", 1}, {"threads", 1}, {"bytes", 1e9}, {"status", -1}, {"part", -1}, {"otherPart", -1}, {"RemoveCopy.i", Survey.Copy}, {"count", 1},
      {"ArrayView.get_Item.c", 0}};

  static T Of<T>(Dictionary<string, T> table, string where, string name, T otherwise) {
    string member = where.Substring(where.IndexOf('.') + 1);
    T found;
    foreach (string key in new[] {where + "." + name, member + "." + name, name}) {
      if (table.TryGetValue(key, out found)) return found;
    }
    return otherwise;
  }

  public static object Of(MethodBase call, ParameterInfo parameter, object self) {
    string where = call.DeclaringType.Name + "." + call.Name, name = parameter.Name;
    Type type = parameter.ParameterType;
    if (type.IsByRef) return null;
    if (type == typeof(string)) return Text(call, where, name, self);
    if (type == typeof(bool)) return true;
    if (type == typeof(long)) return (long)Of(scalars, where, name, 0);
    if (type == typeof(int)) return (int)Of(scalars, where, name, 0);
    if (type == typeof(double)) return Of(scalars, where, name, 0);
    if (type == typeof(double[])) return new double[] {1, 2, 3};
    if (type == typeof(bool[])) return Enumerable.Repeat(true, Points(self)).ToArray();
    if (name == "bytes") return (ArrayArgument)Bytes(call);
    if (type == typeof(ArrayArgument)) {
      return name == "data" ? new double[Points(self)] : name == "xyz" && self is Targets ? Survey.Ball
          : Of(arrays, where, name, Survey.Identity);
    }
    return Objects.Of(type, where, name);
  }

  /// <summary>Those of a real object of the class whose member takes them.</summary>
  static byte[] Bytes(MethodBase call) {
    MethodInfo write = call.DeclaringType.GetMethod("ToBytes");
    object self = Objects.Subject(call.DeclaringType, call.Name);
    return (byte[])write.Invoke(self, EveryCall.Arguments(write, self, false));
  }

  static int Points(object self) {
    var cloud = self as Cloud;
    return cloud == null ? 4 : (int)cloud.Count;
  }

  static string Text(MethodBase call, string where, string name, object self) {
    if (self is Params && name == "name") {
      ParameterInfo[] all = call.GetParameters();
      Type type = all.Length == 2 ? all[1].ParameterType : ((MethodInfo)call).ReturnType;
      return texts[type.Name + ".name"];
    }
    string text = Of(texts, where, name, null);
    bool isFile = name == "path" || name == "source" || name == "target";
    return isFile ? Survey.At(text ?? call.Name + ".svg") : text;
  }
}
