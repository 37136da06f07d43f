// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Threading;
using Jalon;

/// <summary>Every public member of every class with null, zero and extreme values: an exception, never a crash.</summary>
static class Wild {
  internal static List<Noun> Samples() {
    var cloud = new Cloud(Scenes.Plane(12));
    var segmenter = new Segmenter();
    Segmentation segmentation = segmenter.Run(cloud);
    var comparer = new Comparer();
    Model model = Library.SceneCreate();
    var gauge = new Gauge();
    gauge.AddSphere(0.1);
    var targets = new Targets();
    targets.Add("a", new double[] {1, 2, 3});
    return new List<Noun> {cloud, segmenter, segmentation, comparer, comparer.Run(cloud, cloud), model, gauge, targets, new Modeller(),
                           new Registrar(), new Scanner(), new CloudBuilder(), new NormalsOptions(), new JalonTask(),
                           segmentation.GetSegments(), cloud.GetPoints()};
  }

  static IEnumerable<MethodInfo> Members(Type type, BindingFlags kind) {
    return type.GetMethods(BindingFlags.Public | kind).Where(m => m.DeclaringType != typeof(object) && !m.ContainsGenericParameters &&
                                                                 m.Name != "Dispose" && m.ReturnType.Name != "ReadOnlySpan`1");
  }

  static object Value(Type type, int kind) {
    if (type == typeof(long)) return new long[] {0, -1, long.MaxValue, long.MinValue}[kind];
    if (type == typeof(int)) return new[] {0, -1, int.MaxValue, int.MinValue}[kind];
    if (type == typeof(double)) return new[] {0, -1, double.NaN, double.PositiveInfinity}[kind];
    if (type == typeof(string)) return new[] {null, "", "wild \"\n漢", new string('x', 3000)}[kind];
    if (type == typeof(ArrayArgument)) {
      return new ArrayArgument[] {default(ArrayArgument), new double[0], new double[] {double.NaN, 1, 2}, new long[] {-5, 1, 2, 3, 4}}[kind];
    }
    return type.IsValueType ? Activator.CreateInstance(type) : null;
  }

  internal static bool Allowed(Exception error) {
    return error is JalonException || error is OperationCanceledException || error is ObjectDisposedException ||
           error is IndexOutOfRangeException;
  }

  /// <summary>Calls the member; what it throws beyond the documented classes ends the test.</summary>
  static Exception Call(object target, MethodInfo member, int kind) {
    object[] values = member.GetParameters().Select(p => Value(p.ParameterType, kind)).ToArray();
    try {
      var result = member.Invoke(target, values) as IDisposable;
      if (result != null) result.Dispose();
      return null;
    } catch (TargetInvocationException error) {
      if (Allowed(error.InnerException)) return error.InnerException;
      throw new Exception(member.DeclaringType.Name + "." + member.Name + ": " + error.InnerException);
    }
  }

  public static void Members__take_wild_values() {
    int calls = 0;
    foreach (Noun sample in Samples()) {
      foreach (MethodInfo member in Members(sample.GetType(), BindingFlags.Instance)) {
        for (int kind = 0; kind < 4; ++kind, ++calls) Call(sample, member, kind);
      }
      sample.Dispose();
    }
    var types = typeof(Noun).Assembly.GetTypes().Where(t => t == typeof(Library) || t.IsSubclassOf(typeof(Noun)) && t.IsPublic);
    foreach (MethodInfo member in types.SelectMany(t => Members(t, BindingFlags.Static | BindingFlags.DeclaredOnly))) {
      for (int kind = 0; kind < 4; ++kind, ++calls) Call(null, member, kind);
    }
    Check.That(calls > 800, calls + " calls");
  }

  public static void Members__of_disposed_objects_throw() {
    foreach (Noun sample in Samples()) {
      sample.Dispose();
      foreach (MethodInfo member in Members(sample.GetType(), BindingFlags.Instance)) {
        if (member.DeclaringType == typeof(Noun) || sample is ArrayView && member.IsSpecialName && member.Name != "get_Data") continue;
        Exception got = Call(sample, member, 0);
        bool refused = got is ObjectDisposedException || got is InvalidArgumentException;
        Check.That(refused, sample.GetType().Name + "." + member.Name + " of a disposed object: " + got);
      }
    }
  }
}
