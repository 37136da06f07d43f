// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** The file or the request asks for what this version does not do. */
public final class UnsupportedException extends JalonException {
  private static final long serialVersionUID = 1L;

  UnsupportedException(int status, String message) {
    super(status, message);
  }
}
