// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.List;

/**
 * A solid of convex pieces, for clearances along a path. It holds no native memory; one thread at a time.
 *
 * <p>frame: T_gauge_piece, 12 or 16 numbers; left out or null, the piece stands in the gauge's own frame.
 */
public final class Gauge {
  /** Puts one piece into the native list. */
  private interface Piece {
    void addTo(NativeGauge list);
  }

  private final List<Piece> pieces = new ArrayList<>();

  /** A box of these three edges (m) around the origin. */
  public Gauge addBox(double[] edges) {
    return addBox(edges, null);
  }

  /** A box of these three edges (m) around the origin of its frame. */
  public Gauge addBox(double[] edges, double[] frame) {
    return add(list -> list.addBox(Rows.of(edges), Rows.of(frame)));
  }

  /** A ball around the origin. */
  public Gauge addSphere(double radiusM) {
    return addSphere(radiusM, null);
  }

  /** A ball around the origin of its frame. */
  public Gauge addSphere(double radiusM, double[] frame) {
    return add(list -> list.addSphere(radiusM, Rows.of(frame)));
  }

  /** A cylinder along z, centred. */
  public Gauge addCylinder(double radiusM, double lengthM) {
    return addCylinder(radiusM, lengthM, null);
  }

  /** A cylinder along z of its frame, centred. */
  public Gauge addCylinder(double radiusM, double lengthM, double[] frame) {
    return add(list -> list.addCylinder(radiusM, lengthM, Rows.of(frame)));
  }

  /** The convex hull of points (x, y, z, x, ...). */
  public Gauge addHull(double[] points) {
    return addHull(Rows.of(points), null);
  }

  /** The convex hull of points, one array a point. */
  public Gauge addHull(double[][] points) {
    return addHull(Rows.of(points), null);
  }

  /** The convex hull of points (x, y, z, x, ...). */
  public Gauge addHull(DoubleBuffer points) {
    return addHull(Rows.of(points), null);
  }

  /** The convex hull of points (n, 3) in a frame. */
  public Gauge addHull(Rows points, double[] frame) {
    return add(list -> list.addHull(points, Rows.of(frame)));
  }

  /** Number of pieces. */
  public int count() {
    return pieces.size();
  }

  /** How many pieces. */
  @Override
  public String toString() {
    return "Gauge: " + count() + (count() == 1 ? " piece" : " pieces");
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
