// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Jalon {

/// <summary>Texts as they cross to native code: UTF-8 that ends with 0.</summary>
internal static class Text {
  internal static byte[] Utf8(string text) {
    return text == null ? null : Encoding.UTF8.GetBytes(text + "\0");
  }

  internal static string Of(IntPtr text) {
    if (text == IntPtr.Zero) return null;
    int size = 0;
    while (Marshal.ReadByte(text, size) != 0) ++size;
    var bytes = new byte[size];
    Marshal.Copy(text, bytes, 0, size);
    return Encoding.UTF8.GetString(bytes);
  }
}

}
