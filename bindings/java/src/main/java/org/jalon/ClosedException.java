// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** The object was closed before the call. */
public final class ClosedException extends JalonException {
  private static final long serialVersionUID = 1L;

  ClosedException(int status, String message) {
    super(status, message);
  }
}
