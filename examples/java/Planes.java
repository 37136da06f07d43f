// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Planes of a scan.
// Build:  javac -cp jalon.jar Planes.java
// Run:    java -cp jalon.jar:. Planes scan.las
import java.util.Locale;
import org.jalon.*;

class Planes {
  public static void main(String[] files) {
    if (files.length != 1) {
      System.err.println("usage: Planes SCAN");
      System.exit(2);
    }
    try (Cloud cloud = Cloud.read(files[0]); // points, fields, stations
        Segmenter segmenter = Segmenter.create("ransac"); // a worker: parameters, no data
        Segmentation segmentation = segmenter.run(cloud); // what it produces: immutable, keeps the cloud
        Fields segments = segmentation.segments()) { // a table: one row a plane
      final double[] area = segments.doubles("area");
      final double[] sigma = segments.doubles("sigma");
      for (int i = 0; i < area.length; ++i) {
        System.out.printf(Locale.ROOT, "plane %2d: %7.2f m2, sigma %.1f mm%n", i + 1, area[i], 1000 * sigma[i]);
      }
    } catch (JalonException failure) { // the line tells what was wrong
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }
}
