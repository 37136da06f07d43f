// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** A count is beyond what the library, or a Java buffer, holds. */
public final class LimitException extends JalonException {
  private static final long serialVersionUID = 1L;

  LimitException(int status, String message) {
    super(status, message);
  }
}
