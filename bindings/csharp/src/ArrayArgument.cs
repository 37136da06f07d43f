// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>
/// An array of numbers as an argument: an array of .NET of any numeric type, flat (x, y, z, x, ...), of rows (double[,],
/// float[,]) or of arrays of equal length (double[][], copied once); a view of Jalon, without a copy; where .NET has
/// them a ReadOnlyMemory, or a span, copied once. The memory stays where it is during the call. default(ArrayArgument) is no
/// array. What is no array of numbers is refused by the compiler, a bool[] too: it is a mask where a method takes one.
/// </summary>
public struct ArrayArgument {
  internal readonly Array Managed;
  internal readonly ArrayView View;
#if JALON_SPANS
  internal readonly Func<System.Buffers.MemoryHandle> Pin;
  internal readonly int PinnedLength;
  internal readonly ElementType PinnedType;

  private ArrayArgument(Func<System.Buffers.MemoryHandle> pin, int length, ElementType type) : this() {
    Pin = pin;
    PinnedLength = length;
    PinnedType = type;
  }

  /// <summary>Memory of doubles, flat.</summary>
  public static implicit operator ArrayArgument(ReadOnlyMemory<double> memory) {
    return new ArrayArgument(memory.Pin, memory.Length, ElementType.Float64);
  }

  /// <summary>Memory of floats, flat.</summary>
  public static implicit operator ArrayArgument(ReadOnlyMemory<float> memory) {
    return new ArrayArgument(memory.Pin, memory.Length, ElementType.Float32);
  }

  /// <summary>A span of doubles, flat, copied once: a call may be longer than the stack frame it lies in.</summary>
  public static implicit operator ArrayArgument(ReadOnlySpan<double> span) {
    return span.ToArray();
  }

  /// <summary>A span of floats, flat, copied once.</summary>
  public static implicit operator ArrayArgument(ReadOnlySpan<float> span) {
    return span.ToArray();
  }

  /// <summary>A span of indices, copied once.</summary>
  public static implicit operator ArrayArgument(ReadOnlySpan<long> span) {
    return span.ToArray();
  }

  /// <summary>A span of indices, copied once.</summary>
  public static implicit operator ArrayArgument(ReadOnlySpan<int> span) {
    return span.ToArray();
  }
#endif

  private ArrayArgument(Array managed, ArrayView view) : this() {
    Managed = managed;
    View = view;
  }

  /// <summary>What a view of Jalon looks at.</summary>
  public static implicit operator ArrayArgument(ArrayView view) {
    return new ArrayArgument(null, view);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(double[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(float[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(long[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(ulong[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(int[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(uint[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(short[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(ushort[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(byte[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Flat.</summary>
  public static implicit operator ArrayArgument(sbyte[] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(double[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(float[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(long[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(ulong[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(int[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(uint[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(short[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(ushort[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(byte[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows.</summary>
  public static implicit operator ArrayArgument(sbyte[,] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows, copied once.</summary>
  public static implicit operator ArrayArgument(double[][] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows, copied once.</summary>
  public static implicit operator ArrayArgument(float[][] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows, copied once.</summary>
  public static implicit operator ArrayArgument(long[][] array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>Rows, copied once.</summary>
  public static implicit operator ArrayArgument(int[][] array) {
    return new ArrayArgument(array, null);
  }
}

}
