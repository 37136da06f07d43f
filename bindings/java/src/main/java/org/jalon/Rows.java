// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.nio.ShortBuffer;

/**
 * Numbers on their way into the library, whatever array holds them. Calls take arrays and buffers themselves; their form with
 * Rows is for arrays of different kinds in one call, and for what has more elements an item than the call can know:
 * {@code Rows.of(values).by(3)} is a field of vectors.
 *
 * <p>Arrays hold the numbers row by row, (x, y, z, x, ...). Buffers count from position to limit; direct ones in native byte
 * order are used where they are, all others are copied. Rows refer to what they were made of, until the call has ended.
 */
public final class Rows {
  // Read by name from java_support.h.
  final Object memory;
  final int type;
  final long count;
  final int components;
  final long strideBytes;
  final boolean flat;

  private Rows(Object memory, int type, long count, int components, long strideBytes, boolean flat) {
    this.memory = memory;
    this.type = type;
    this.count = count;
    this.components = components;
    this.strideBytes = strideBytes;
    this.flat = flat;
  }

  /** The same numbers as rows of so many elements. */
  public Rows by(int elements) {
    final long all = count * components;
    if (elements < 1 || all % elements != 0) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, all + " elements are no rows of " + elements);
    }
    if (strideBytes * count != all * size(type)) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "the items do not stand side by side");
    }
    return new Rows(memory, type, all / elements, elements, (long) size(type) * elements, false);
  }

  /** Of double[]; null for null. */
  public static Rows of(double[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.FLOAT64, numbers.length);
  }

  /** Of float[]; null for null. */
  public static Rows of(float[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.FLOAT32, numbers.length);
  }

  /** Of long[]; null for null. */
  public static Rows of(long[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.INT64, numbers.length);
  }

  /** Of int[]; null for null. */
  public static Rows of(int[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.INT32, numbers.length);
  }

  /** Of short[]; null for null. */
  public static Rows of(short[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.INT16, numbers.length);
  }

  /** Of byte[]: 0 to 255; null for null. */
  public static Rows of(byte[] numbers) {
    return numbers == null ? null : flat(numbers, Jalon.UINT8, numbers.length);
  }

  /** Of one array a row, all of one length; null for null. */
  public static Rows of(double[][] rows) {
    if (rows == null) {
      return null;
    }
    for (int i = 0; i < rows.length; ++i) {
      if (rows[i] == null) {
        throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "row " + i + " is null");
      }
    }
    final int columns = rows.length == 0 ? 1 : rows[0].length;
    final double[] all = new double[Math.multiplyExact(rows.length, columns)];
    for (int i = 0; i < rows.length; ++i) {
      if (rows[i].length != columns) {
        throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
            "row " + i + " has " + rows[i].length + " numbers, the first one has " + columns);
      }
      System.arraycopy(rows[i], 0, all, i * columns, columns);
    }
    return new Rows(all, Jalon.FLOAT64, rows.length, Math.max(1, columns), 8L * Math.max(1, columns), false);
  }

  /** Of an array that the library gave, without a copy; null for null. */
  public static Rows of(Array array) {
    return array == null ? null
        : new Rows(array.bytes(), array.type(), array.count(), array.components(), array.strideBytes(), false);
  }

  /** Of the buffer's numbers from position to limit; null for null. */
  public static Rows of(DoubleBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return isNative(numbers.isDirect(), numbers.order()) ? flat(numbers.slice(), Jalon.FLOAT64, numbers.remaining())
        : of(DoubleBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** Of the buffer's numbers from position to limit; null for null. */
  public static Rows of(FloatBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return isNative(numbers.isDirect(), numbers.order()) ? flat(numbers.slice(), Jalon.FLOAT32, numbers.remaining())
        : of(FloatBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** Of the buffer's numbers from position to limit; null for null. */
  public static Rows of(LongBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return isNative(numbers.isDirect(), numbers.order()) ? flat(numbers.slice(), Jalon.INT64, numbers.remaining())
        : of(LongBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** Of the buffer's numbers from position to limit; null for null. */
  public static Rows of(IntBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return isNative(numbers.isDirect(), numbers.order()) ? flat(numbers.slice(), Jalon.INT32, numbers.remaining())
        : of(IntBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** Of the buffer's numbers from position to limit; null for null. */
  public static Rows of(ShortBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return isNative(numbers.isDirect(), numbers.order()) ? flat(numbers.slice(), Jalon.INT16, numbers.remaining())
        : of(ShortBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** Of the buffer's bytes, 0 to 255, from position to limit; null for null. */
  public static Rows of(ByteBuffer numbers) {
    if (numbers == null) {
      return null;
    }
    return numbers.isDirect() ? flat(numbers.slice(), Jalon.UINT8, numbers.remaining())
        : of(ByteBuffer.allocate(numbers.remaining()).put(numbers.duplicate()).array());
  }

  /** A field of 0 and 1. Not public: as indices it would mean the points 0 and 1. */
  static Rows flags(boolean[] flags) {
    if (flags == null) {
      return null;
    }
    final byte[] bytes = new byte[flags.length];
    for (int i = 0; i < flags.length; ++i) {
      bytes[i] = (byte) (flags[i] ? 1 : 0);
    }
    return of(bytes);
  }

  private static int size(int type) {
    return type == Jalon.FLOAT64 || type == Jalon.INT64 || type == Jalon.UINT64 ? 8
        : type == Jalon.INT16 || type == Jalon.UINT16 ? 2
        : type == Jalon.INT8 || type == Jalon.UINT8 ? 1 : 4;
  }

  private static Rows flat(Object memory, int type, int count) {
    return new Rows(memory, type, count, 1, size(type), true);
  }

  private static boolean isNative(boolean direct, ByteOrder order) {
    return direct && order == ByteOrder.nativeOrder();
  }

  /** How many rows of how many numbers of which type. */
  @Override
  public String toString() {
    return "Rows: " + Described.shape(count, components, type);
  }
}
