// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** The call was cancelled, by Task.cancel() or by its listener; nothing was changed. */
public final class CancelledException extends JalonException {
  private static final long serialVersionUID = 1L;

  CancelledException(int status, String message) {
    super(status, message);
  }
}
