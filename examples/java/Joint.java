// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// A mobile scan and a building model, each wrong in its own way, brought into agreement by their standard deviations.
// Build:  javac -cp jalon.jar Joint.java
// Run:    java -cp jalon.jar:. Joint street.obj drive.ply drive.txt adjusted.txt
import java.util.Locale;
import org.jalon.*;

class Joint {
  public static void main(String[] files) {
    if (files.length != 4) {
      System.err.println("usage: Joint MODEL CLOUD TRAJECTORY ADJUSTED");
      System.exit(2);
    }
    // Facades are cut into strips, which may bend; roofs come along: they hide what is behind them.
    try (Model buildings = Model.read(files[0]);
        BuildingStripsParams options = new BuildingStripsParams().setOthers(true).setTouchM(2);
        ModelBuildingStripsResult strips = buildings.buildingStrips(options);
        Cloud cloud = Cloud.read(files[1]);
        Trajectory drive = Trajectory.read(files[2]);
        Adjustment adjustment = drive.adjust(cloud, strips.model());
        Trajectory adjusted = adjustment.trajectory()) {
      tell(adjustment);
      adjusted.write(files[3]);
    } catch (JalonException failure) {
      System.err.println(Jalon.statusName(failure.status()) + ": " + failure.getMessage());
      System.exit(1);
    }
  }

  private static void tell(Adjustment adjustment) {
    try (Fields summary = adjustment.summary();
        Fields controls = adjustment.controls();
        Fields blocks = adjustment.blocks()) {
      System.out.printf(Locale.ROOT, "%s, %d points matched, p %.3f%n",
          summary.doubles("converged")[0] != 0 ? "converged" : "not converged", (long) summary.doubles("matched")[0],
          summary.doubles("p_value")[0]);
      say("start of the drive", controls.doubles("correction"), controls.doubles("sigma"), 0);
      final double[] offset = blocks.doubles("offset");
      final double[] sigma = blocks.doubles("sigma");
      for (int i = 0; i < offset.length / 2; ++i) {
        say("block " + (i + 1), offset, sigma, i);
      }
    }
  }

  private static void say(String what, double[] by, double[] sigma, int row) {
    System.out.printf(Locale.ROOT, "%s: %.3f %.3f m, sigma %.3f %.3f m%n", what, by[2 * row], by[2 * row + 1], sigma[2 * row],
        sigma[2 * row + 1]);
  }
}
