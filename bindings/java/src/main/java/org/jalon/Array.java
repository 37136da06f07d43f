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
 * An array that the library made or holds, count() items of components() elements each: coordinates (n, 3), a column of a
 * table, indices. It owns, or shares with the object it came from, the memory it shows; that object may be closed.
 *
 * <p>Views are direct, read-only, in native byte order, without a copy, O(1). They keep the memory alive as long as any
 * of them is reachable, whether this array and its source are closed or not. A Java buffer ends at 2^31 - 1 bytes; larger
 * arrays are seen in pieces: {@link #bytes(long, long)}. Any thread may read.
 */
public final class Array implements AutoCloseable {
  private static final int[] SIZES = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  private final long count;
  private final int components;
  private final int type;
  private final long strideBytes;
  private NativeArray source;
  private boolean viewed;

  private Array(NativeArray source) {
    this.source = source;
    count = source.count();
    components = (int) source.components();
    type = source.type();
    strideBytes = source.strideBytes();
  }

  static Array of(long pointer) {
    return pointer == 0 ? null : new Array(new NativeArray(pointer, true));
  }

  /** Number of items. */
  public long count() {
    return count;
  }

  /** Elements an item, e.g. 3 of coordinates. */
  public int components() {
    return components;
  }

  /** Element type, one of INT8 ... FLOAT64 of {@link JalonConstants}. */
  public int type() {
    return type;
  }

  /** Bytes from one item to the next. */
  public long strideBytes() {
    return strideBytes;
  }

  private boolean packed() {
    return strideBytes == (long) SIZES[type] * components || count < 2;
  }

  /** All bytes; {@link LimitException} above 2^31 - 1 of them. */
  public ByteBuffer bytes() {
    return bytes(0, count);
  }

  /** The bytes of so many items from this one on: how arrays of more than 2^31 - 1 bytes are read. */
  public synchronized ByteBuffer bytes(long firstItem, long items) {
    if (source == null) {
      throw new ClosedException(Jalon.ERROR_INVALID_ARGUMENT, "the array is closed");
    }
    if (firstItem < 0 || items < 0 || firstItem > count - items) {
      throw new IndexOutOfBoundsException("items " + firstItem + " to " + (firstItem + items) + " of " + count);
    }
    final NativeArray kept = source;
    final ByteBuffer root = kept.directBuffer(firstItem, items);
    viewed = true;
    // All views of root refer to it; what frees the memory waits in the cleaner until the last of them is gone.
    NativeObject.keepWith(root, kept);
    return root.asReadOnlyBuffer().order(ByteOrder.nativeOrder());
  }

  private ByteBuffer bytesOf(int wanted, int alternative, String name) {
    if (type != wanted && type != alternative) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
          "the elements are of type " + Described.type(type) + ", not " + name + ": toDoubles() converts");
    }
    if (!packed()) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT,
          "the items do not stand side by side (" + strideBytes + " bytes each): toDoubles() copies them");
    }
    return bytes();
  }

  /** View of float64 elements. */
  public DoubleBuffer doubles() {
    return bytesOf(Jalon.FLOAT64, Jalon.FLOAT64, "double").asDoubleBuffer();
  }

  /** View of float32 elements. */
  public FloatBuffer floats() {
    return bytesOf(Jalon.FLOAT32, Jalon.FLOAT32, "float").asFloatBuffer();
  }

  /** View of 64-bit integers; unsigned ones above 2^63 - 1 look negative ({@code NO_POINT} is -1). */
  public LongBuffer longs() {
    return bytesOf(Jalon.INT64, Jalon.UINT64, "long").asLongBuffer();
  }

  /** View of 32-bit integers; see Integer.toUnsignedLong for unsigned ones. */
  public IntBuffer ints() {
    return bytesOf(Jalon.INT32, Jalon.UINT32, "int").asIntBuffer();
  }

  /** View of 16-bit integers; see Short.toUnsignedInt for unsigned ones. */
  public ShortBuffer shorts() {
    return bytesOf(Jalon.INT16, Jalon.UINT16, "short").asShortBuffer();
  }

  /** A copy of all elements, of any type, row by row; {@link LimitException} above 2^31 - 1 elements. */
  public double[] toDoubles() {
    final long elements = count * components;
    if (elements > Integer.MAX_VALUE - 8) {
      throw new LimitException(Jalon.ERROR_LIMIT,
          elements + " elements: a Java array holds 2^31 - 1; read pieces with bytes(first, items)");
    }
    final double[] values = new double[(int) elements];
    final int itemsAtOnce = (int) Math.max(1, (1 << 24) / Math.max(1, strideBytes));
    int at = 0;
    for (long first = 0; first < count; first += itemsAtOnce) {
      final long items = Math.min(itemsAtOnce, count - first);
      final ByteBuffer piece = bytes(first, items);
      for (long i = 0; i < items; ++i) {
        for (int c = 0; c < components; ++c) {
          values[at++] = element(piece, (int) (i * strideBytes) + c * SIZES[type]);
        }
      }
    }
    return values;
  }

  private double element(ByteBuffer bytes, int at) {
    switch (type) {
      case 1: return bytes.get(at);
      case 2: return Byte.toUnsignedInt(bytes.get(at));
      case 3: return bytes.getShort(at);
      case 4: return Short.toUnsignedInt(bytes.getShort(at));
      case 5: return bytes.getInt(at);
      case 6: return Integer.toUnsignedLong(bytes.getInt(at));
      case 7: return bytes.getLong(at);
      case 8: {
        final long value = bytes.getLong(at);
        return value >= 0 ? value : (value >>> 1 | value & 1) * 2.0;
      }
      case 9: return bytes.getFloat(at);
      default: return bytes.getDouble(at);
    }
  }

  /** Ends the use of this array; the memory goes at once unless a view was handed out, else with the last view. */
  @Override
  public synchronized void close() {
    if (source != null && !viewed) {
      source.freeNow();
    }
    source = null;
  }

  /** How many items of how many elements of which type. */
  @Override
  public String toString() {
    return "Array: " + Described.shape(count, components, type);
  }
}
