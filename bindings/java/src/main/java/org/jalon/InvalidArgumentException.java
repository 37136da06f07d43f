// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** An argument is missing, of the wrong shape or out of its range. */
public final class InvalidArgumentException extends JalonException {
  private static final long serialVersionUID = 1L;

  InvalidArgumentException(int status, String message) {
    super(status, message);
  }
}
