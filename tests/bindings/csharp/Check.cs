// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Reflection;
using Jalon;

/// <summary>Counts what holds. Tests are the public static methods of the classes below, named Behaviour__detail.</summary>
static class Check {
  static int passed, failed;
  static string current;

  public static void That(bool holds, string what) {
    if (!holds) throw new Exception(what);
  }

  public static void Equal<T>(T expected, T got, string what) {
    if (!Equals(expected, got)) throw new Exception(what + ": expected " + expected + ", got " + got);
  }

  /// <summary>The exception of exactly this type that the action throws.</summary>
  public static T Throws<T>(Action action) where T : Exception {
    try {
      action();
    } catch (T expected) {
      if (expected.GetType() == typeof(T)) return expected;
      throw new Exception("expected " + typeof(T).Name + ", got " + expected.GetType().Name);
    }
    throw new Exception("expected " + typeof(T).Name + ", nothing was thrown");
  }

  public static void Figure(string text) {
    Console.WriteLine("FIGURE csharp " + text);
  }

  public static bool Full {
    get { return Environment.GetEnvironmentVariable("JALON_FULL") == "1"; }
  }

  static void Run(MethodInfo test) {
    current = test.DeclaringType.Name + "." + test.Name;
    try {
      test.Invoke(null, null);
      ++passed;
      Console.WriteLine("ok - " + current);
    } catch (TargetInvocationException error) {
      ++failed;
      Console.WriteLine("not ok - " + current + ": " + error.InnerException);
    }
  }

  static int Main(string[] args) {
    if (args.Length == 1 && args[0] == "--public") {
      PublicMembers.Print();
      return 0;
    }
    foreach (Type type in new[] {typeof(Arrays), typeof(Calls), typeof(Storms), typeof(Texts), typeof(Parameters), typeof(Lifetimes),
                                 typeof(ObjectBytes), typeof(Shapes), typeof(EveryCall), typeof(Wild), typeof(Misuse)}) {
      foreach (MethodInfo test in type.GetMethods(BindingFlags.Public | BindingFlags.Static | BindingFlags.DeclaredOnly)) {
        if (args.Length == 0 || args.Any(a => (type.Name + "." + test.Name).Contains(a))) Run(test);
      }
    }
    Console.WriteLine("{0} passed, {1} failed, 0 skipped", passed, failed);
    return failed == 0 ? 0 : 1;
  }
}

/// <summary>Clouds that the tests share.</summary>
static class Scenes {
  /// <summary>A square plane of n x n points, 10 cm apart, with national coordinates and a little noise.</summary>
  public static double[,] Plane(int n) {
    var xyz = new double[n * n, 3];
    var random = new Random(7);
    for (int i = 0; i < n * n; ++i) {
      xyz[i, 0] = 2600000 + 0.1 * (i % n);
      xyz[i, 1] = 1200000 + 0.1 * (i / n);
      xyz[i, 2] = 400 + 0.002 * random.NextDouble();
    }
    return xyz;
  }
}
