// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** A file could not be opened, read or written. */
public final class FileException extends JalonException {
  private static final long serialVersionUID = 1L;

  FileException(int status, String message) {
    super(status, message);
  }
}
