// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** A file is not what its name or its header says; the message tells where. */
public final class FormatException extends JalonException {
  private static final long serialVersionUID = 1L;

  FormatException(int status, String message) {
    super(status, message);
  }
}
