// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A small survey: a scene, two scans of it, what is made of them. Real data for every call. */
final class Survey {
  static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  static final double[] BALL = {3, 4, 5}; // its radius is 0.0725 m
  static final double[] POSES = {1, 0, 0, 2, 0, 1, 0, -2, 0, 0, 1, 2, 1, 0, 0, 20, 0, 1, 0, -2, 0, 0, 1, 2}; // of a gauge, two

  static final double[] DRIVE = {0, 0, 2, 50, 0, 2, 100, 10, 2};
  static final double[] SIGMAS = {0.02, 0.02, 0.03, 0.02, 0.02, 0.03, 0.05, 0.06, 0.07};

  private static Survey made;

  final Path folder;
  final Model scene = Jalon.sceneCreate();
  final Cloud scan = scanned(1);
  final Cloud second = scanned(2);
  final Cloud ball = Cloud.create(sphere(400));
  final Cloud pipe = Cloud.create(cylinder(400));
  final Segmentation segmentation;
  final double[] onWall; // a point of the largest plane
  final Model model;
  final Model repeated; // with a copy of an element where data are missing
  final int copy;
  final Comparison comparison;
  final Comparison reverse;
  final Registration registration;
  final NoiseLaw law;
  final SceneDriveScenarioResult driven = drivenStreet(); // a short drive, its cloud and strips
  final Adjustment adjustment = adjusted(driven);
  final Fields forwardPoints;
  final Fields reversePoints;
  final Fields changes;
  final GaugeSweepResult swept;

  private Survey() {
    try {
      folder = Files.createTempDirectory("jalon_survey");
      Runtime.getRuntime().addShutdownHook(new Thread(this::removeFiles));
      Files.writeString(folder.resolve("m3c2.txt"), "[General]\nM3C2VER=1\nNormalScale=0.5\n");
    } catch (IOException failure) {
      throw new UncheckedIOException(failure);
    }
    withFields(scan);
    withFields(second);
    try (Segmenter segmenter = Segmenter.create().set("distance_tolerance_m", 0.02).set("min_points", 30);
        Modeller modeller = Modeller.create(); Comparer comparer = Comparer.create();
        Registrar registrar = Registrar.create("targets")) {
      segmentation = segmenter.run(scan);
      model = modeller.run(scan, segmentation);
      comparison = comparer.run(scan, second);
      reverse = comparer.run(second, scan);
      registration = registrar.runTargets(targets(), targets());
    }
    final int first = indexOf(segmentation.points().doubles("label"), 1);
    onWall = java.util.Arrays.copyOfRange(scan.points().toDoubles(), 3 * first, 3 * first + 3);
    repeated = seenPastAScreen();
    copy = indexOf(repeated.parts().doubles("evidence"), Jalon.EVIDENCE_COPIED);
    law = NoiseLaw.fit(scan, "deviation");
    final ComparisonDiagnoseResult diagnosis = comparison.diagnose(reverse);
    forwardPoints = diagnosis.forward();
    reversePoints = diagnosis.reverse();
    changes = diagnosis.changes();
    swept = Jalon.gaugeSweep(gauge(), POSES, scan);
    scan.write(path("scan.las"));
    drive().write(path("drive.txt"));
    model.write(path("model.obj"));
  }

  private void removeFiles() {
    for (java.io.File file : folder.toFile().listFiles()) {
      file.delete();
    }
    folder.toFile().delete();
  }

  static synchronized Survey get() {
    if (made == null) {
      made = new Survey();
    }
    return made;
  }

  String path(String name) {
    return folder.resolve(name).toString();
  }

  /** A copy that may be changed. */
  static Cloud copy(Cloud cloud) {
    final boolean[] all = new boolean[(int) cloud.count()];
    java.util.Arrays.fill(all, true);
    return cloud.select(all);
  }

  /** A wall with two rows of five windows, panes 20 cm behind, as one eye sees them past a screen that hides a window whole. */
  private static Model seenPastAScreen() {
    final double[] eye = {7, -9, 3};
    final List<double[]> points = new java.util.ArrayList<>();
    final List<Integer> planes = new java.util.ArrayList<>();
    for (double x = 0.01; x < 14; x += 0.025) {
      for (double z = 0.01; z < 7; z += 0.025) {
        final double toPane = 9 / 9.2;
        final double paneX = eye[0] + (x - eye[0]) * toPane;
        final double paneZ = eye[2] + (z - eye[2]) * toPane;
        if (isScreen(x, z)) {
          points.add(new double[] {x, -3.5, z});
          planes.add(3);
        }
        if (!isInWindow(x, z) && !isScreen(eye[0] + (x - eye[0]) * 5.5 / 9, eye[2] + (z - eye[2]) * 5.5 / 9)) {
          points.add(new double[] {x, 0.002 * Math.sin(7919 * x + 104729 * z), z});
          planes.add(1);
        }
        if (isInWindow(x, z) && isInWindow(paneX, paneZ) && !isScreen(eye[0] + (x - eye[0]) * 5.5 / 9.2, eye[2] + (z - eye[2]) * 5.5 / 9.2)) {
          points.add(new double[] {x, 0.2, z});
          planes.add(2);
        }
      }
    }
    final double[] xyz = points.stream().flatMapToDouble(java.util.Arrays::stream).toArray();
    try (Cloud cloud = Cloud.create(xyz); Modeller modeller = Modeller.create("facade")) {
      cloud.setField("plane", planes.stream().mapToInt(Integer::intValue).toArray());
      cloud.setStation("eye", new double[] {1, 0, 0, eye[0], 0, 1, 0, eye[1], 0, 0, 1, eye[2]});
      try (Segmentation walls = Segmentation.fromLabels(cloud, "plane")) {
        return modeller.run(cloud, walls);
      }
    }
  }

  private static boolean isScreen(double x, double z) {
    return x > 8.13 && x < 9.11 && z > 3.46 && z < 4.74;
  }

  private static boolean isInWindow(double x, double z) {
    for (int i = 0; i < 10; ++i) {
      final double left = 1 + 2.7 * (i / 2);
      final double foot = 1 + 3.0 * (i % 2);
      if (x > left && x < left + 1.1 && z > foot && z < foot + 1.6) {
        return true;
      }
    }
    return false;
  }

  private static SceneDriveScenarioResult drivenStreet() {
    try (DriveScenarioParams options = new DriveScenarioParams().setLegM(40).setCorner(false).setRevolutionsPerS(10).setPulses(200)) {
      return Jalon.sceneDriveScenario(options);
    }
  }

  static final String NAILS = "id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n";
  static final String SIGHTS = "from to direction zenith distance code\nA B 0 100 50 -\nA C 50 100 30 350\nB C 170 100 36.2 350\nB A 0 100 50 -\n";

  static Network network() {
    return Network.adjust(SIGHTS, NAILS);
  }

  static Adjustment adjusted(SceneDriveScenarioResult driven) {
    try (AdjustParams options = new AdjustParams().setCovariance(true)) {
      return driven.trajectory().adjust(driven.cloud(), driven.model(), options);
    }
  }

  private static int indexOf(double[] values, double wanted) {
    int i = 0;
    while (values[i] != wanted) {
      ++i;
    }
    return i;
  }

  private Cloud scanned(long seed) {
    try (Scanner scanner = Scanner.create().set("horizontal_step_rad", 0.02).set("vertical_step_rad", 0.02).set("seed", seed)) {
      return scanner.run(scene);
    }
  }

  /** What field tools work on: deviations, their gradient, classes and labels. */
  private static void withFields(Cloud cloud) {
    final int n = (int) cloud.count();
    final double[] deviation = new double[n];
    final int[] label = new int[n];
    for (int i = 0; i < n; ++i) {
      deviation[i] = 0.001 + 0.004 * ((i * 7919L) % 1009) / 1009.0;
      label[i] = 1 + i % 2;
    }
    cloud.setField("deviation", deviation, "m");
    cloud.setField("slope", deviation);
    cloud.setField("label", label);
    cloud.setField("truth", label);
    cloud.computeCovariances();
  }

  static Targets targets() {
    final Targets targets = new Targets();
    final double[][] places = {{0, 0, 0}, {10, 0, 0}, {0, 7, 0}, {0, 0, 4}, {3, 5, 2}};
    for (int i = 0; i < places.length; ++i) {
      targets.add("T" + i, places[i]);
    }
    return targets;
  }

  /** Three epochs of mobile mapping, at the times 10, 20 and 30 s. */
  static Trajectory drive() {
    return Trajectory.create(new double[] {10, 20, 30}, DRIVE, new double[9], SIGMAS, SIGMAS, SIGMAS, "EPSG:2154");
  }

  /** A gauge as a model. */
  static Model tetrahedron() {
    return Model.createMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  }

  static Gauge gauge() {
    return new Gauge().addBox(new double[] {1, 1, 2});
  }

  static List<Cloud> clouds() {
    return List.of(copy(get().scan), copy(get().second));
  }

  /** A spiral of points on the ball. */
  private static double[][] sphere(int n) {
    final double[][] xyz = new double[n][];
    for (int i = 0; i < n; ++i) {
      final double z = 1 - 2 * (i + 0.5) / n;
      final double r = 0.0725 * Math.sqrt(1 - z * z);
      xyz[i] = new double[] {BALL[0] + r * Math.cos(2.4 * i), BALL[1] + r * Math.sin(2.4 * i), BALL[2] + 0.0725 * z};
    }
    return xyz;
  }

  private static double[][] cylinder(int n) {
    final double[][] xyz = new double[n][];
    for (int i = 0; i < n; ++i) {
      xyz[i] = new double[] {0.3 * Math.cos(2.4 * i), 0.3 * Math.sin(2.4 * i), 2.0 * i / n};
    }
    return xyz;
  }
}
