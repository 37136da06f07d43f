// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.function.Supplier;

/** What {@code Cloud.crop} gives. close() closes its parts. */
public final class CloudCropResult implements AutoCloseable {
  private final Cloud inside;
  private final Cloud outside;

  /** Takes inside over; closes it when there is no outside. */
  CloudCropResult(Cloud inside, Supplier<Cloud> outside) {
    this.inside = inside;
    try {
      this.outside = outside.get();
    } catch (RuntimeException failure) {
      inside.close();
      throw failure;
    }
  }

  /** The points for which the mask is true. */
  public Cloud inside() {
    return inside;
  }

  /** The others. */
  public Cloud outside() {
    return outside;
  }

  @Override
  public void close() {
    inside.close();
    outside.close();
  }

  /** The values of all parts. */
  @Override
  public String toString() {
    return Described.result("CloudCropResult", "inside", inside, "outside", outside);
  }
}
