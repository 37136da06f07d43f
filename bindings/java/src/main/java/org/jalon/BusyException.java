// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** The object is in use by a call on another thread: a second call with the same task, or close(). */
public final class BusyException extends JalonException {
  private static final long serialVersionUID = 1L;

  BusyException(int status, String message) {
    super(status, message);
  }
}
