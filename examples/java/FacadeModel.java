// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// From a scan to a vector model with openings, for CAD.
// Build:  javac -cp jalon.jar FacadeModel.java
// Run:    java -cp jalon.jar:. FacadeModel scan.las model.dxf
import java.util.Locale;
import org.jalon.*;

class FacadeModel {
  /** Planes, then the walls among them with their windows, doors and reveals. */
  private static Model modelOf(String scan) {
    try (Cloud cloud = Cloud.read(scan);
        Segmenter segmenter = Segmenter.create("ransac");
        Segmentation segmentation = segmenter.run(cloud);
        Modeller modeller = Modeller.create("facade")) {
      return modeller.run(cloud, segmentation);
    }
  }

  public static void main(String[] files) {
    if (files.length != 2) {
      System.err.println("usage: FacadeModel SCAN MODEL");
      System.exit(2);
    }
    try (Model model = modelOf(files[0]); Fields faces = model.faces(); Fields parts = model.parts()) {
      model.write(files[1]);
      System.out.printf(Locale.ROOT, "%d faces%n", faces.doubles("area").length);
      final double[] width = parts.doubles("width");
      final double[] height = parts.doubles("height");
      for (int i = 0; i < width.length; ++i) {
        final ModelPartResult part = model.part(i);
        if (part.partClass().equals("window") || part.partClass().equals("door")) {
          System.out.printf(Locale.ROOT, "%s: %.3f x %.3f m%n", part.name(), width[i], height[i]);
        }
      }
    } catch (JalonException failure) {
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }
}
