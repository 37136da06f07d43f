// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>
/// A read-only look at an array that an object of the library owns, without a copy: Count items of Components elements.
/// It keeps that memory alive until it is disposed of or collected, whatever happens to the object it came from.
/// </summary>
public sealed class ArrayView : Noun {
  private readonly IntPtr data;
  private readonly long stride_bytes;

  [DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_Array")]
  private static extern void DeleteArray(IntPtr array);

  private sealed class NativeBox : Box {
    internal NativeBox(IntPtr array) : base(array, 0) {}
    protected override void Delete(IntPtr array) {
      DeleteArray(array);
    }
  }

  internal static ArrayView Wrap(IntPtr array) {
    return array == IntPtr.Zero ? null : new ArrayView(array);
  }

  private ArrayView(IntPtr array) : base(new NativeBox(array)) {
    Count = Number.Of(LibraryPINVOKE.Array_count(array));
    Components = (int)LibraryPINVOKE.Array_components(array);
    Type = (ElementType)LibraryPINVOKE.Array_type(array);
    stride_bytes = Number.Of(LibraryPINVOKE.Array_stride_bytes(array));
    data = LibraryPINVOKE.Array_memory_of(array);
  }

  internal override string About() {
    return Described.Shape(Count, Components, Type);
  }

  /// <summary>Number of items, e.g. points.</summary>
  public long Count { get; private set; }

  /// <summary>Elements an item, e.g. 3 for coordinates.</summary>
  public int Components { get; private set; }

  /// <summary>Type of the elements as they are stored.</summary>
  public ElementType Type { get; private set; }

  /// <summary>Bytes from one item to the next.</summary>
  public long StrideBytes {
    get { return stride_bytes; }
  }

  /// <summary>Count times Components.</summary>
  public long Length {
    get { return checked(Count * Components); }
  }

  /// <summary>The memory, which stays while the view is neither disposed of nor collected: GC.KeepAlive.</summary>
  public IntPtr Data {
    get {
      Live();
      return data;
    }
  }

  /// <summary>Element c of item i as a double.</summary>
  public unsafe double this[long i, int c = 0] {
    get {
      if (i < 0 || i >= Count || c < 0 || c >= Components) throw new IndexOutOfRangeException();
      byte* at = (byte*)Acquire() + i * stride_bytes + c * Elements.SizeOf(Type);
      double value = Elements.ToDouble(at, Type);
      Release();
      return value;
    }
  }

  /// <summary>
  /// All elements, item by item, in an array of their own type: double[] for coordinates, ulong[] for indices.
  /// LimitException where an array of .NET cannot hold them: take them in pieces by CopyTo.
  /// </summary>
  public Array ToArray() {
    Array copy = Array.CreateInstance(Elements.ManagedType(Type), Fitting(Length));
    Fill(copy, 0, Count);
    return copy;
  }

  /// <summary>All elements, item by item, in an array of this type, which must be that of the elements.</summary>
  public T[] ToArray<T>() where T : struct {
    Same(typeof(T));
    return (T[])ToArray();
  }

  /// <summary>All elements as doubles, item by item, whatever their type.</summary>
  public unsafe double[] ToDoubles() {
    if (Type == ElementType.Float64) return (double[])ToArray();
    var copy = new double[Fitting(Length)];
    int size = Elements.SizeOf(Type);
    byte* from = (byte*)Acquire();
    try {
      for (long i = 0; i < copy.LongLength; ++i) {
        copy[i] = Elements.ToDouble(from + i / Components * stride_bytes + i % Components * size, Type);
      }
    } finally {
      Release();
    }
    return copy;
  }

  /// <summary>The items as rows of an array of their own type: double[,] for coordinates.</summary>
  public Array ToRows() {
    Fitting(Length);
    Array copy = Array.CreateInstance(Elements.ManagedType(Type), Fitting(Count), Components);
    Fill(copy, 0, Count);
    return copy;
  }

  /// <summary>
  /// Copies count items, from item first on, to the beginning of an array of the elements' type: for views that no
  /// array of .NET can hold at once.
  /// </summary>
  public void CopyTo(Array destination, long first, long count) {
    if (destination == null) throw new InvalidArgumentException("destination must not be null");
    Same(destination.GetType().GetElementType());
    if (first < 0 || count < 0 || count > Count - first || count * Components > destination.LongLength) {
      throw new InvalidArgumentException("items " + first + " to " + (first + count) + " are not within the " + Count +
                                         " of the view or not within the array");
    }
    Fill(destination, first, count);
  }

#if JALON_SPANS
  /// <summary>
  /// The elements without a copy. They must be side by side and of this type; the view must be neither disposed of nor
  /// collected while the span is used (GC.KeepAlive).
  /// </summary>
  public unsafe ReadOnlySpan<T> AsSpan<T>() where T : struct {
    Same(typeof(T));
    if (stride_bytes != (long)Components * Elements.SizeOf(Type) && Count > 1) {
      throw new UnsupportedException("the items of this view do not lie side by side");
    }
    Live();
    return new ReadOnlySpan<T>((void*)data, Fitting(Length));
  }
#endif

  private unsafe void Fill(Array copy, long first, long count) {
    long row_bytes = (long)Components * Elements.SizeOf(Type);
    if (copy.LongLength == 0 || count == 0) return;
    byte* from = (byte*)Acquire() + first * stride_bytes;
    GCHandle pin = GCHandle.Alloc(copy, GCHandleType.Pinned);
    try {
      byte* to = (byte*)pin.AddrOfPinnedObject();
      if (stride_bytes == row_bytes) {
        Buffer.MemoryCopy(from, to, count * row_bytes, count * row_bytes);
      } else {
        for (long i = 0; i < count; ++i) Buffer.MemoryCopy(from + i * stride_bytes, to + i * row_bytes, row_bytes, row_bytes);
      }
    } finally {
      pin.Free();
      Release();
    }
  }

  private void Same(Type wanted) {
    if (Elements.TypeOf(wanted) == Type) return;
    throw new InvalidArgumentException("the elements are " + Elements.ManagedType(Type).Name + ", not " + wanted.Name);
  }

  private static int Fitting(long length) {
    if (length <= int.MaxValue) return (int)length;
    throw new LimitException(length + " elements are more than an array of .NET holds: use CopyTo");
  }

  /// <summary>The memory, which stays until Release.</summary>
  internal IntPtr Acquire() {
    bool acquired = false;
    Live().DangerousAddRef(ref acquired);
    return data;
  }

  internal void Release() {
    BoxUnchecked.DangerousRelease();
  }
}

}
