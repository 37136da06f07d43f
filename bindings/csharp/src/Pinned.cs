// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>An argument's memory, which stays where it is during one call.</summary>
internal sealed class Pinned : IDisposable {
  private GCHandle handle;
  private ArrayView view;
#if JALON_SPANS
  private System.Buffers.MemoryHandle memory;
#endif

  /// <summary>The array as native code takes it; zero for none.</summary>
  internal IntPtr Pointer { get; private set; }

  internal Pinned(ArrayArgument argument, string name, bool required) {
    try {
      Take(argument, name);
      if (required && Pointer == IntPtr.Zero) throw new InvalidArgumentException(name + " must not be null");
    } catch {
      Dispose();
      throw;
    }
  }

  private void Take(ArrayArgument argument, string name) {
    if (argument.View != null) {
      IntPtr data = argument.View.Acquire();
      view = argument.View;
      Borrow(data, view.Type, view.Count, view.Components, view.StrideBytes);
    } else if (argument.Managed != null) {
      Take(argument.Managed is Array[] ? Joined((Array[])argument.Managed, name) : argument.Managed, name);
    }
#if JALON_SPANS
    else if (argument.Pin != null) {
      memory = argument.Pin();
      unsafe {
        Borrow((IntPtr)memory.Pointer, argument.PinnedType, argument.PinnedLength, 0, 0);
      }
    }
#endif
  }

  private void Take(Array array, string name) {
    ElementType type = Elements.TypeOf(array.GetType().GetElementType());
    if (type == 0) {
      throw new InvalidArgumentException(name + " must be an array of numbers, not of " +
                                         array.GetType().GetElementType().Name);
    }
    if (array.Rank > 2) throw new InvalidArgumentException(name + " must have one or two dimensions, not " + array.Rank);
    handle = GCHandle.Alloc(array, GCHandleType.Pinned);
    IntPtr data = array.LongLength == 0 ? IntPtr.Zero : handle.AddrOfPinnedObject();
    if (array.Rank == 1) {
      Borrow(data, type, array.LongLength, 0, 0);
    } else {
      long columns = array.GetLongLength(1);
      Borrow(data, type, array.GetLongLength(0), columns, columns * Elements.SizeOf(type));
    }
  }

  /// <summary>Rows of equal length as one array.</summary>
  private static Array Joined(Array[] rows, string name) {
    if (rows.Length == 0) return new double[0];
    int columns = rows[0] == null ? 0 : rows[0].Length;
    Type element = rows.GetType().GetElementType().GetElementType();
    if (Elements.TypeOf(element) == 0) {
      throw new InvalidArgumentException(name + " must have rows of numbers, not of " + element.Name);
    }
    Array joined = Array.CreateInstance(element, rows.Length, columns);
    int row_bytes = columns * Elements.SizeOf(Elements.TypeOf(element));
    for (int i = 0; i < rows.Length; ++i) {
      if (rows[i] == null) throw new InvalidArgumentException(name + ": row " + i + " is null");
      if (rows[i].Length != columns || rows[i].Rank != 1) {
        throw new InvalidArgumentException(name + " must have rows of equal length; row " + i + " differs from row 0");
      }
      Buffer.BlockCopy(rows[i], 0, joined, checked(i * row_bytes), row_bytes);
    }
    return joined;
  }

  private void Borrow(IntPtr data, ElementType type, long count, long components, long stride_bytes) {
    Pointer = LibraryPINVOKE.borrow_array(data, (int)type, (ulong)count, checked((uint)components), (ulong)stride_bytes);
    if (Pointer == IntPtr.Zero) throw new NativeMemoryException("out of memory");
  }

  public void Dispose() {
    if (Pointer != IntPtr.Zero) LibraryPINVOKE.free_array(Pointer);
    Pointer = IntPtr.Zero;
    if (handle.IsAllocated) handle.Free();
    if (view != null) view.Release();
    view = null;
#if JALON_SPANS
    memory.Dispose();
#endif
  }
}

}
