// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Arrays in, progress and cancel, arrays out: normals of points that a program holds in memory.
// Build:  javac -cp jalon.jar Progress.java
// Run:    java -cp jalon.jar:. Progress
import java.nio.FloatBuffer;
import java.util.Locale;
import org.jalon.*;

class Progress {
  private static final int SIDE = 1000;

  public static void main(String[] none) {
    final float[] xyz = new float[3 * SIDE * SIDE]; // a gentle dome of a million points
    for (int i = 0; i < SIDE * SIDE; ++i) {
      final float x = 0.01f * (i % SIDE) - 5;
      final float y = 0.01f * (i / SIDE) - 5;
      xyz[3 * i] = x;
      xyz[3 * i + 1] = y;
      xyz[3 * i + 2] = -0.02f * (x * x + y * y);
    }
    try (Cloud cloud = Cloud.create(xyz, 0);
        NormalsParams options = new NormalsParams().setK(16);
        Task task = Task.create().onProgress((fraction, stage) -> {
          System.err.printf(Locale.ROOT, "\r%3.0f %% %s", 100 * fraction, stage);
          return true; // false cancels, as an exception and task.cancel() of another thread do
        })) {
      cloud.computeNormals(options, task);
      try (Fields fields = cloud.fields(); Array normals = fields.view("normal")) {
        final FloatBuffer view = normals.floats(); // the library's own memory
        final int top = 3 * (SIDE * SIDE / 2 + SIDE / 2);
        System.out.printf(Locale.ROOT, "%nnormal at the top: %.4f %.4f %.4f%n", view.get(top), view.get(top + 1), view.get(top + 2));
      }
    } catch (JalonException failure) {
      System.err.println(failure.getMessage());
      System.exit(1);
    }
  }
}
