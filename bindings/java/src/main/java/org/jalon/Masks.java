// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** Masks of points: one a point, true for those that are meant. */
final class Masks {
  private Masks() {}

  /** The indices of those that are true; null for null. The mask must be of so many points. */
  static Rows indices(boolean[] mask, long points) {
    if (mask == null) {
      return null;
    }
    if (mask.length != points) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
          "the mask has " + mask.length + " items, the cloud has " + points + " points");
    }
    int count = 0;
    for (boolean meant : mask) {
      count += meant ? 1 : 0;
    }
    final int[] indices = new int[count];
    int at = 0;
    for (int i = 0; i < mask.length; ++i) {
      if (mask[i]) {
        indices[at++] = i;
      }
    }
    return Rows.of(indices);
  }

  /** The same; one that means no point is refused, because no indices stand for all points there. */
  static Rows some(boolean[] mask, long points) {
    final Rows indices = indices(mask, points);
    if (indices != null && indices.count == 0) {
      throw new InsufficientDataException(Jalon.ERROR_INSUFFICIENT_DATA, "the mask means no point");
    }
    return indices;
  }

  static boolean[] inverted(boolean[] mask) {
    final boolean[] others = new boolean[mask.length];
    for (int i = 0; i < mask.length; ++i) {
      others[i] = !mask[i];
    }
    return others;
  }
}
