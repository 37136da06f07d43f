// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** A call of Jalon failed; the message is one helpful line. */
public class JalonException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final int status;

  JalonException(int status, String message) {
    super(message);
    this.status = status;
  }

  /** The status of the C library, one of the ERROR_ constants of {@link Jalon}. */
  public int status() {
    return status;
  }

  static JalonException of(int status, byte[] message) {
    return new JalonException(status, Text.of(message));
  }
}
