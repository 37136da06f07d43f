// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** The data does not determine the answer, e.g. all points on one line. */
public final class DegenerateException extends JalonException {
  private static final long serialVersionUID = 1L;

  DegenerateException(int status, String message) {
    super(status, message);
  }
}
