// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// What has changed between two scans: distances, then connected regions of changed points.
// Build:  javac -cp jalon.jar Changes.java
// Run:    java -cp jalon.jar:. Changes before.las after.las
import java.util.Locale;
import org.jalon.*;

class Changes {
  public static void main(String[] files) {
    if (files.length != 2) {
      System.err.println("usage: Changes BEFORE AFTER");
      System.exit(2);
    }
    // Distances from local planes of the reference; only what its scanners could have seen counts.
    try (Cloud before = Cloud.read(files[0]);
        Cloud after = Cloud.read(files[1]);
        Comparer comparer = Comparer.create("distance").setLocalModel("plane").setMaxDistanceM(2);
        Comparison comparison = comparer.run(before, after);
        RegionsParams options = new RegionsParams().setCriterion("threshold").setThresholdM(0.1).setMinPoints(50);
        ComparisonRegionsResult found = comparison.regions(options)) {
      final double[] points = found.regions().doubles("points");
      final double[] area = found.regions().doubles("area");
      final double[] mean = found.regions().doubles("mean");
      for (int i = 0; i < points.length; ++i) {
        System.out.printf(Locale.ROOT, "region %d: %d points, %.3f m2, mean %.3f m%n", i + 1, (long) points[i], area[i], mean[i]);
      }
    } catch (JalonException failure) {
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }
}
