// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>A managed array that stays where it is during one call; null is no array.</summary>
internal sealed class Pinned : IDisposable {
  private GCHandle handle;
  internal IntPtr Pointer { get; private set; }

  [DllImport("jalon_csharp", EntryPoint = "jalon_csharp_array")]
  private static extern IntPtr Make(IntPtr data, int type, ulong count);

  [DllImport("jalon_csharp", EntryPoint = "jalon_csharp_array_free")]
  private static extern void Free(IntPtr array);

  internal Pinned(System.Array array) {
    Pointer = IntPtr.Zero;
    if (array == null) return;
    int type = TypeOf(array.GetType().GetElementType());
    handle = GCHandle.Alloc(array, GCHandleType.Pinned);
    Pointer = Make(handle.AddrOfPinnedObject(), type, (ulong)array.LongLength);
    if (Pointer == IntPtr.Zero) {
      handle.Free();
      throw new OutOfMemoryException();
    }
  }

  private static int TypeOf(Type element) {
    if (element == typeof(double)) return Library.FLOAT64;
    if (element == typeof(float)) return Library.FLOAT32;
    if (element == typeof(sbyte)) return Library.INT8;
    if (element == typeof(byte)) return Library.UINT8;
    if (element == typeof(short)) return Library.INT16;
    if (element == typeof(ushort)) return Library.UINT16;
    if (element == typeof(int)) return Library.INT32;
    if (element == typeof(uint)) return Library.UINT32;
    if (element == typeof(long)) return Library.INT64;
    if (element == typeof(ulong)) return Library.UINT64;
    throw new ArgumentException("an array of numbers is needed, not of " + element);
  }

  public void Dispose() {
    if (Pointer == IntPtr.Zero) return;
    Free(Pointer);
    handle.Free();
    Pointer = IntPtr.Zero;
  }
}

}
