// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>
/// An array of numbers as an argument: an array of .NET of any numeric type, flat (x, y, z, x, ...), of rows (double[,],
/// float[,]) or of arrays of equal length (double[][], copied once); a view of Jalon, without a copy; where .NET has
/// them a ReadOnlyMemory. The memory stays where it is during the call. default(ArrayArgument) is no array.
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
#endif

  private ArrayArgument(Array managed, ArrayView view) : this() {
    Managed = managed;
    View = view;
  }

  /// <summary>An array of .NET.</summary>
  public static implicit operator ArrayArgument(Array array) {
    return new ArrayArgument(array, null);
  }

  /// <summary>What a view of Jalon looks at.</summary>
  public static implicit operator ArrayArgument(ArrayView view) {
    return new ArrayArgument(null, view);
  }
}

}
