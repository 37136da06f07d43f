// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** There are too few points, pairs or observations for an answer. */
public final class InsufficientDataException extends JalonException {
  private static final long serialVersionUID = 1L;

  InsufficientDataException(int status, String message) {
    super(status, message);
  }
}
