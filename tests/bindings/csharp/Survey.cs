// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Jalon;

/// <summary>A small survey: a scene, two scans of it, what is made of them. Real data for every call.</summary>
static class Survey {
  public static readonly double[] Ball = {3, 4, 5};  // its radius is 0.0725 m
  public static readonly double[] Poses = {1, 0, 0, 2, 0, 1, 0, -2, 0, 0, 1, 2, 1, 0, 0, 20, 0, 1, 0, -2, 0, 0, 1, 2};  // of a gauge, two
  public static readonly double[,] Identity = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  public static readonly double[,] Path3 = {{0, 0, 2}, {50, 0, 2}, {100, 10, 2}};
  public static readonly double[,] Sigmas = {{0.02, 0.02, 0.03}, {0.02, 0.02, 0.03}, {0.05, 0.06, 0.07}};

  public static readonly string Folder = Path.Combine(Path.GetTempPath(), "jalon_survey_" + Guid.NewGuid().ToString("N"));
  public static readonly Model Scene = Library.SceneCreate();
  public static readonly Cloud Scan = Scanned(1), Second = Scanned(2);
  public static readonly Cloud Sphere = new Cloud(Spiral(400)), Pipe = new Cloud(Cylinder(400));
  public static readonly Segmentation Planes;
  public static readonly Model Facade, Repeated;
  public static readonly Comparison Forward, Reverse;
  public static readonly Registration Registered;
  public static readonly NoiseLaw Law;
  public static readonly SceneDriveScenarioResult Driven = DrivenStreet();  // a short drive, its cloud and strips
  public static readonly Adjustment Adjusted = Driven.Trajectory.Adjust(Driven.Cloud, Driven.Model, new AdjustOptions { Covariance = true });
  public static readonly ComparisonDiagnoseResult Diagnosis;
  public static readonly GaugeSweepResult Swept;
  public static readonly double[] OnWall;  // a point of the largest plane
  public static readonly long Copy;        // the part of Repeated that completes a pattern

  static Survey() {
    Directory.CreateDirectory(Folder);
    AppDomain.CurrentDomain.ProcessExit += (sender, end) => Directory.Delete(Folder, true);
    File.WriteAllText(At("m3c2.txt"), "[General]\nM3C2VER=1\nNormalScale=0.5\n");
    Planes = new Segmenter { DistanceToleranceM = 0.02, MinPoints = 30 }.Run(Scan);
    Facade = new Modeller().Run(Scan, Planes);
    Forward = new Comparer().Run(Scan, Second);
    Reverse = new Comparer().Run(Second, Scan);
    Registered = new Registrar("targets").RunTargets(Targets(), Targets());
    Law = NoiseLaw.Fit(Scan, "deviation");
    Diagnosis = Forward.Diagnose(Reverse);
    Swept = Library.GaugeSweep(Gauge(), Poses, Scan);
    int first = Array.IndexOf(Planes.GetPoints().Doubles("label"), 1.0);
    OnWall = Enumerable.Range(0, 3).Select(c => Scan.GetPoints()[first, c]).ToArray();
    Repeated = SeenPastAScreen();
    Copy = Array.IndexOf(Repeated.GetParts().Doubles("evidence"), (double)Constants.EvidenceCopied);
    Scan.Write(At("scan.las"));
    Drive().Write(At("drive.txt"));
    Facade.Write(At("model.obj"));
  }

  public static string At(string name) {
    return Path.Combine(Folder, name);
  }

  /// <summary>One that may be changed.</summary>
  public static Cloud CopyOf(Cloud cloud) {
    return cloud.Select(Enumerable.Repeat(true, (int)cloud.Count).ToArray());
  }

  public static Targets Targets() {
    var targets = new Targets();
    foreach (double[] place in new[] {new double[] {0, 0, 0}, new double[] {10, 0, 0}, new double[] {0, 7, 0}, new double[] {0, 0, 4}}) {
      targets.Add("T" + targets.Count, place);
    }
    return targets;
  }

  public static Gauge Gauge() {
    var gauge = new Gauge();
    gauge.AddBox(new double[] {1, 1, 2});
    return gauge;
  }

  /// <summary>Three epochs of mobile mapping, at the times 10, 20 and 30 s.</summary>
  public static Trajectory Drive() {
    return new Trajectory(new double[] {10, 20, 30}, Path3, new double[3, 3], Sigmas, Sigmas, Sigmas, "EPSG:2154");
  }

  public const string Nails = "id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n";
  public const string Sights = "from to direction zenith distance code\nA B 0 100 50 -\nA C 50 100 30 350\nB C 170 100 36.2 350\nB A 0 100 50 -\n";

  static SceneDriveScenarioResult DrivenStreet() {
    return Library.SceneDriveScenario(new DriveScenarioOptions { LegM = 40, Corner = false, RevolutionsPerS = 10, Pulses = 200 });
  }

  /// <summary>A gauge as a model.</summary>
  public static Model Tetrahedron() {
    return Model.CreateMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  }

  static Cloud Scanned(long seed) {
    using (var scanner = new Scanner { HorizontalStepRad = 0.02, VerticalStepRad = 0.02, Seed = seed }) {
      Cloud cloud = scanner.Run(Scene);
      int n = (int)cloud.Count;
      double[] deviation = Enumerable.Range(0, n).Select(i => 0.001 + 0.004 * (i * 7919L % 1009) / 1009.0).ToArray();
      int[] label = Enumerable.Range(0, n).Select(i => 1 + i % 2).ToArray();
      cloud.SetField("deviation", deviation, "m");
      cloud.SetField("slope", deviation);
      cloud.SetField("label", label);
      cloud.SetField("truth", label);
      cloud.ComputeCovariances();
      return cloud;
    }
  }

  /// <summary>A wall with two rows of five windows, panes 20 cm behind, as one eye sees them past a screen that hides a window whole.</summary>
  static Model SeenPastAScreen() {
    double[] eye = {7, -9, 3};
    var points = new List<double>();
    var planes = new List<int>();
    Action<double, double, double, int> add = (x, y, z, plane) => {
      points.AddRange(new[] {x, y, z});
      planes.Add(plane);
    };
    for (double x = 0.01; x < 14; x += 0.025) {
      for (double z = 0.01; z < 7; z += 0.025) {
        Func<double, bool> isHidden = share => IsScreen(eye[0] + (x - eye[0]) * share, eye[2] + (z - eye[2]) * share);
        if (IsScreen(x, z)) add(x, -3.5, z, 3);
        if (!IsInWindow(x, z)) {
          if (!isHidden(5.5 / 9)) add(x, 0.002 * Math.Sin(7919 * x + 104729 * z), z, 1);
        } else if (IsInWindow(eye[0] + (x - eye[0]) * 9 / 9.2, eye[2] + (z - eye[2]) * 9 / 9.2) && !isHidden(5.5 / 9.2)) {
          add(x, 0.2, z, 2);
        }
      }
    }
    using (var cloud = new Cloud(points.ToArray()))
    using (var modeller = new Modeller("facade")) {
      cloud.SetField("plane", planes.ToArray());
      cloud.SetStation("eye", new double[] {1, 0, 0, eye[0], 0, 1, 0, eye[1], 0, 0, 1, eye[2]});
      using (Segmentation walls = Segmentation.FromLabels(cloud, "plane")) return modeller.Run(cloud, walls);
    }
  }

  static bool IsScreen(double x, double z) {
    return x > 8.13 && x < 9.11 && z > 3.46 && z < 4.74;
  }

  static bool IsInWindow(double x, double z) {
    return Enumerable.Range(0, 10).Any(i => {
      double left = 1 + 2.7 * (i / 2), foot = 1 + 3.0 * (i % 2);
      return x > left && x < left + 1.1 && z > foot && z < foot + 1.6;
    });
  }

  static double[] Spiral(int n) {
    return Enumerable.Range(0, n).SelectMany(i => {
      double z = 1 - 2 * (i + 0.5) / n, r = 0.0725 * Math.Sqrt(1 - z * z);
      return new[] {Ball[0] + r * Math.Cos(2.4 * i), Ball[1] + r * Math.Sin(2.4 * i), Ball[2] + 0.0725 * z};
    }).ToArray();
  }

  static double[] Cylinder(int n) {
    return Enumerable.Range(0, n).SelectMany(i => new[] {0.3 * Math.Cos(2.4 * i), 0.3 * Math.Sin(2.4 * i), 2.0 * i / n}).ToArray();
  }
}
