// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.ArrayList;
import java.util.List;

/** A solid of convex pieces, for clearances along a path. It holds no native memory; one thread at a time. */
public final class Gauge {
  /** Puts one piece into the native list. */
  private interface Piece {
    void addTo(NativeGauge list);
  }

  private final List<Piece> pieces = new ArrayList<>();

  /** A box of these three edges (m) around the origin of its frame. frame: 12 or 16 numbers, null = identity. */
  public Gauge addBox(Object edges, Object frame) {
    return add(list -> list.addBox(edges, frame));
  }

  /** A ball. */
  public Gauge addSphere(double radiusM, Object frame) {
    return add(list -> list.addSphere(radiusM, frame));
  }

  /** A cylinder along z of its frame, centred. */
  public Gauge addCylinder(double radiusM, double lengthM, Object frame) {
    return add(list -> list.addCylinder(radiusM, lengthM, frame));
  }

  /** The convex hull of points (n, 3). */
  public Gauge addHull(Object points, Object frame) {
    return add(list -> list.addHull(points, frame));
  }

  /** Number of pieces. */
  public int count() {
    return pieces.size();
  }

  private Gauge add(Piece piece) {
    try (NativeGauge probe = new NativeGauge()) { // says now what is wrong with it
      piece.addTo(probe);
    }
    pieces.add(piece);
    return this;
  }

  static NativeGauge made(Gauge gauge) {
    if (gauge == null) {
      return null;
    }
    final NativeGauge list = new NativeGauge();
    gauge.pieces.forEach(piece -> piece.addTo(list));
    return list;
  }
}
