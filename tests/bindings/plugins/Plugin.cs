// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

/// <summary>What a host loads: it calls Jalon, and takes a failure.</summary>
public static class Plugin {
  public static string Work() {
    using (var cloud = new Jalon.Cloud(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0})) {
      try {
        cloud.RemoveField("none");
      } catch (Jalon.NotFoundException) {
        return Jalon.Library.Version() + ", " + cloud.Count + " points";
      }
    }
    return "no exception";
  }
}
