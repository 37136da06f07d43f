// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>A native box that stays during one call.</summary>
internal struct Held : IDisposable {
  private readonly Box box;
  private readonly bool held;

  /// <summary>The box, NULL for Box.None.</summary>
  internal readonly IntPtr Pointer;

  internal Held(Box box) {
    this.box = box;
    held = false;
    box.DangerousAddRef(ref held);
    Pointer = box.DangerousGetHandle();
  }

  public void Dispose() {
    if (held) box.DangerousRelease();
  }
}

/// <summary>A text in native memory during one call: UTF-8 that ends with 0; NULL for null.</summary>
internal struct NativeText : IDisposable {
  internal readonly IntPtr Pointer;

  internal NativeText(string text) {
    Pointer = IntPtr.Zero;
    if (text == null) return;
    byte[] bytes = Text.Utf8(text);
    Pointer = Marshal.AllocHGlobal(bytes.Length);
    Marshal.Copy(bytes, 0, Pointer, bytes.Length);
  }

  public void Dispose() {
    if (Pointer != IntPtr.Zero) Marshal.FreeHGlobal(Pointer);
  }
}

}
