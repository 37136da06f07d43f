// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// One scan laid onto another: the pose, what it is worth, and the moved scan.
// Build:  javac -cp jalon.jar Register.java
// Run:    java -cp jalon.jar:. Register reference.las moving.las registered.las
import java.util.Locale;
import org.jalon.*;

class Register {
  private static void print(Registration registration) {
    final double[] pose = registration.pose(); // 3 x 4, row by row
    for (int i = 0; i < 12; i += 4) {
      System.out.printf(Locale.ROOT, "%.6f %.6f %.6f %.4f%n", pose[i], pose[i + 1], pose[i + 2], pose[i + 3]);
    }
    try (Fields summary = registration.summary()) {
      final double[] c = summary.doubles("covariance"); // of rotation and shift, 6 x 6
      System.out.printf(Locale.ROOT, "%s, sigma of the shift %.2f %.2f %.2f mm%n",
          summary.doubles("converged")[0] != 0 ? "converged" : "not converged",
          1000 * Math.sqrt(c[21]), 1000 * Math.sqrt(c[28]), 1000 * Math.sqrt(c[35]));
    }
  }

  public static void main(String[] files) {
    if (files.length != 3) {
      System.err.println("usage: Register REFERENCE MOVING REGISTERED");
      System.exit(2);
    }
    try (Cloud reference = Cloud.read(files[0]);
        Cloud moving = Cloud.read(files[1]);
        Registrar registrar = Registrar.create("icp");
        Registration registration = registrar.run(reference, moving)) {
      print(registration);
      try (Cloud registered = registration.apply(moving)) {
        registered.write(files[2]);
      }
    } catch (JalonException failure) {
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }
}
