// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Jalon {

/// <summary>Texts as they cross to native code: UTF-8 that ends with 0, never the code page of the system.</summary>
internal static class Text {
  private static readonly Encoding strict = new UTF8Encoding(false, true);

  internal static byte[] Utf8(string text) {
    if (text == null) return null;
    if (text.IndexOf('\0') >= 0) throw new InvalidArgumentException("a text must not hold the character U+0000");
    try {
      return strict.GetBytes(text + "\0");
    } catch (EncoderFallbackException) {
      throw new InvalidArgumentException("a text holds half a surrogate pair, which is no character");
    }
  }

  /// <summary>Texts that are not empty, each with a zero behind it and one more behind the last.</summary>
  internal static string[] ListOf(IntPtr block) {
    var texts = new List<string>();
    for (int size; (size = SizeOf(block)) > 0; block = IntPtr.Add(block, size + 1)) texts.Add(Of(block));
    return texts.ToArray();
  }

  internal static string Of(IntPtr text) {
    if (text == IntPtr.Zero) return null;
    var bytes = new byte[SizeOf(text)];
    Marshal.Copy(text, bytes, 0, bytes.Length);
    return Encoding.UTF8.GetString(bytes);
  }

  private static int SizeOf(IntPtr text) {
    int size = 0;
    while (Marshal.ReadByte(text, size) != 0) ++size;
    return size;
  }
}

}
