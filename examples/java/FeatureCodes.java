// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// What a surveyor coded in the field, "ID;X;Y;Z;code" a line, gives the points of a scan their classes and objects, and
// makes a model of them.
// Build:  javac -cp jalon.jar FeatureCodes.java
// Run:    java -cp jalon.jar:. FeatureCodes scan.las codes.txt classified.las objects.dxf
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.jalon.*;

class FeatureCodes {
  public static void main(String[] files) throws IOException {
    if (files.length != 4) {
      System.err.println("usage: FeatureCodes SCAN CODES CLASSIFIED MODEL");
      System.exit(2);
    }
    final String codes = new String(Files.readAllBytes(Path.of(files[1])), StandardCharsets.UTF_8);
    try (Cloud cloud = Cloud.read(files[0]);
        Segmenter segmenter = Segmenter.create("survey_codes").set("codes", codes);
        Segmentation coded = segmenter.run(cloud);
        Cloud classified = coded.cloud();
        Modeller modeller = Modeller.create("coded_objects");
        Model model = modeller.run(cloud, coded)) {
      tellSegments(coded);
      classified.write(files[2]);
      for (int i = 0; i < model.partCount(); ++i) {
        final ModelPartResult part = model.part(i);
        System.out.println(part.partClass() + ": " + part.name());
      }
      model.write(files[3]);
    } catch (JalonException failure) {
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }

  /** Every object is a segment; its source label is its number in the list. */
  private static void tellSegments(Segmentation coded) {
    try (Fields segments = coded.segments()) {
      final double[] object = segments.doubles("source_label");
      final double[] points = segments.doubles("inliers");
      for (int i = 0; i < object.length; ++i) {
        System.out.printf(Locale.ROOT, "object %d: %d points%n", (long) object[i], (long) points[i]);
      }
    }
  }
}
