// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** Texts as they cross to native code: UTF-8 that ends with 0. */
final class Text {
  private Text() {}

  static byte[] utf8(String text) {
    if (text != null && text.indexOf('\0') >= 0) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "a text with a zero character in it");
    }
    if (text == null) {
      return null;
    }
    try {
      final ByteBuffer bytes = StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(text));
      return Arrays.copyOf(bytes.array(), bytes.limit() + 1);
    } catch (CharacterCodingException failure) {
      throw new InvalidArgumentException(Jalon.ERROR_INVALID_ARGUMENT, "a text holds half a surrogate pair, which is no character");
    }
  }

  static String of(byte[] bytes) {
    return bytes == null ? null : new String(bytes, StandardCharsets.UTF_8);
  }

  /** Texts that are not empty, each with a zero behind it. */
  static List<String> listOf(byte[] block) {
    return block.length == 0 ? List.of() : List.of(of(block).split("\0"));
  }

  /** Called by the native code, as log is. */
  static boolean progress(ProgressListener listener, double fraction, byte[] stage) {
    return listener.onProgress(fraction, of(stage));
  }

  static void log(LogListener listener, int level, byte[] line) {
    listener.onLine(level, of(line));
  }
}
