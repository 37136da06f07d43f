// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.nio.ShortBuffer;

/**
 * Numbers on their way into the library. Every parameter of type Object takes
 *
 * <ul>
 *   <li>double[], float[], long[], int[], short[], byte[] (0..255): row by row, (x, y, z, x, ...);
 *   <li>double[][]: one array a row;
 *   <li>the NIO buffers of these, from position to limit: direct ones in native byte order without a copy;
 *   <li>an {@link Array} that the library gave;
 *   <li>Rows.of(numbers, components), where the number of elements an item is not known otherwise: a field of vectors.
 * </ul>
 */
public final class Rows {
  // Read by name from java_support.h.
  final Object memory;
  final int type;
  final long count;
  final int components;
  final long strideBytes;

  private Rows(Object memory, int type, long count, int components, long strideBytes) {
    this.memory = memory;
    this.type = type;
    this.count = count;
    this.components = components;
    this.strideBytes = strideBytes;
  }

  /** The numbers as rows of so many elements. */
  public static Rows of(Object numbers, int components) {
    final Rows rows = of(numbers);
    final long elements = rows == null ? 0 : rows.count * rows.components;
    if (rows == null || components < 1 || elements % components != 0) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
          elements + " elements are no rows of " + components);
    }
    if (rows.strideBytes * rows.count != elements * size(rows.type)) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "the items do not stand side by side");
    }
    return new Rows(rows.memory, rows.type, elements / components, components, (long) size(rows.type) * components);
  }

  /** What a parameter was given, null for null. */
  static Rows of(Object numbers) {
    if (numbers == null || numbers instanceof Rows) {
      return (Rows) numbers;
    }
    if (numbers instanceof double[]) {
      return flat(numbers, Jalon.FLOAT64, ((double[]) numbers).length);
    }
    if (numbers instanceof float[]) {
      return flat(numbers, Jalon.FLOAT32, ((float[]) numbers).length);
    }
    if (numbers instanceof long[]) {
      return flat(numbers, Jalon.INT64, ((long[]) numbers).length);
    }
    if (numbers instanceof int[]) {
      return flat(numbers, Jalon.INT32, ((int[]) numbers).length);
    }
    if (numbers instanceof short[]) {
      return flat(numbers, Jalon.INT16, ((short[]) numbers).length);
    }
    if (numbers instanceof byte[]) {
      return flat(numbers, Jalon.UINT8, ((byte[]) numbers).length);
    }
    if (numbers instanceof double[][]) {
      return nested((double[][]) numbers);
    }
    if (numbers instanceof Array) {
      final Array array = (Array) numbers;
      return new Rows(array.bytes(), array.type(), array.count(), array.components(), array.strideBytes());
    }
    if (numbers instanceof Buffer) {
      return buffer((Buffer) numbers);
    }
    throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
        "numbers are needed (double[], DoubleBuffer, ..., see Rows), not " + numbers.getClass().getName());
  }

  private static int size(int type) {
    return type == Jalon.FLOAT64 || type == Jalon.INT64 || type == Jalon.UINT64 ? 8
        : type == Jalon.INT16 || type == Jalon.UINT16 ? 2
        : type == Jalon.INT8 || type == Jalon.UINT8 ? 1 : 4;
  }

  private static Rows flat(Object memory, int type, int count) {
    return new Rows(memory, type, count, 1, size(type));
  }

  private static Rows nested(double[][] rows) {
    final int components = rows.length == 0 ? 1 : rows[0].length;
    final double[] all = new double[Math.multiplyExact(rows.length, components)];
    for (int i = 0; i < rows.length; ++i) {
      if (rows[i].length != components) {
        throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
            "row " + i + " has " + rows[i].length + " numbers, the first one has " + components);
      }
      System.arraycopy(rows[i], 0, all, i * components, components);
    }
    return new Rows(all, Jalon.FLOAT64, rows.length, Math.max(1, components), 8L * Math.max(1, components));
  }

  private static Rows buffer(Buffer given) {
    final boolean direct = given.isDirect();
    final int count = given.remaining();
    if (given instanceof DoubleBuffer) {
      final DoubleBuffer from = (DoubleBuffer) given;
      return direct && nativeOrder(from.order()) ? flat(from.slice(), Jalon.FLOAT64, count)
          : of(DoubleBuffer.allocate(count).put(from.duplicate()).array());
    }
    if (given instanceof FloatBuffer) {
      final FloatBuffer from = (FloatBuffer) given;
      return direct && nativeOrder(from.order()) ? flat(from.slice(), Jalon.FLOAT32, count)
          : of(FloatBuffer.allocate(count).put(from.duplicate()).array());
    }
    if (given instanceof LongBuffer) {
      final LongBuffer from = (LongBuffer) given;
      return direct && nativeOrder(from.order()) ? flat(from.slice(), Jalon.INT64, count)
          : of(LongBuffer.allocate(count).put(from.duplicate()).array());
    }
    if (given instanceof IntBuffer) {
      final IntBuffer from = (IntBuffer) given;
      return direct && nativeOrder(from.order()) ? flat(from.slice(), Jalon.INT32, count)
          : of(IntBuffer.allocate(count).put(from.duplicate()).array());
    }
    if (given instanceof ShortBuffer) {
      final ShortBuffer from = (ShortBuffer) given;
      return direct && nativeOrder(from.order()) ? flat(from.slice(), Jalon.INT16, count)
          : of(ShortBuffer.allocate(count).put(from.duplicate()).array());
    }
    if (given instanceof ByteBuffer) {
      final ByteBuffer from = (ByteBuffer) given;
      return direct ? flat(from.slice(), Jalon.UINT8, count) : of(ByteBuffer.allocate(count).put(from.duplicate()).array());
    }
    throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "a buffer of numbers is needed, not of characters");
  }

  private static boolean nativeOrder(ByteOrder order) {
    return order == ByteOrder.nativeOrder();
  }
}
