// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Points known in one frame, for registration. It holds no native memory; one thread at a time. */
public final class Targets {
  private final List<Consumer<NativeTargets>> targets = new ArrayList<>();

  /** A target without a name at xyz (3 numbers, m): found by its distances to the others. */
  public Targets add(double[] xyz) {
    return add(null, xyz, null);
  }

  /** A target at xyz (3 numbers, m), as certain as the parameter "sigma_m" says. name may be null. */
  public Targets add(String name, double[] xyz) {
    return add(name, xyz, null);
  }

  /** covariance: 9 numbers (m2), or null. */
  public Targets add(String name, double[] xyz, double[] covariance) {
    final Consumer<NativeTargets> target = list -> list.add(name, Rows.of(xyz), Rows.of(covariance));
    try (NativeTargets probe = new NativeTargets()) { // says now what is wrong with it
      target.accept(probe);
    }
    targets.add(target);
    return this;
  }

  /** Number of targets. */
  public int count() {
    return targets.size();
  }

  /** How many targets. */
  @Override
  public String toString() {
    return "Targets: " + count();
  }

  static NativeTargets made(Targets given) {
    if (given == null) {
      return null;
    }
    final NativeTargets list = new NativeTargets();
    given.targets.forEach(target -> target.accept(list));
    return list;
  }
}
