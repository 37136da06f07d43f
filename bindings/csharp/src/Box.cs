// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>The native box of an object. It stays during every call that holds it (Held).</summary>
internal abstract class Box : SafeHandle {
  private readonly long pressure_bytes;
  private GCHandle named;

  /// <param name="box">The native box, which is taken over.</param>
  /// <param name="pressure_bytes">Native memory that the collector shall know of.</param>
  protected Box(IntPtr box, long pressure_bytes) : base(IntPtr.Zero, true) {
    SetHandle(box);
    this.pressure_bytes = pressure_bytes;
    if (pressure_bytes > 0) GC.AddMemoryPressure(pressure_bytes);
  }

  /// <summary>No object: NULL in C.</summary>
  internal static readonly Box None = new NoBox();

  public override bool IsInvalid {
    get { return handle == IntPtr.Zero; }
  }

  /// <summary>What native code calls an object by, which whoever holds the box during a call keeps.</summary>
  internal IntPtr Name(object host) {
    named = GCHandle.Alloc(host, GCHandleType.Weak);
    return GCHandle.ToIntPtr(named);
  }

  /// <summary>Frees the native box.</summary>
  protected abstract void Delete(IntPtr box);

  protected override bool ReleaseHandle() {
    Delete(handle);
    if (named.IsAllocated) named.Free();
    if (pressure_bytes > 0) GC.RemoveMemoryPressure(pressure_bytes);
    return true;
  }

  private sealed class NoBox : Box {
    internal NoBox() : base(IntPtr.Zero, 0) {}
    protected override void Delete(IntPtr box) {}
  }
}

}
