// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** The behaviours as JUnit tests. */
class BehavioursTest {
  @TestFactory
  Stream<DynamicTest> behaviours() {
    return Behaviours.all().entrySet().stream().map(one -> DynamicTest.dynamicTest(one.getKey(), one.getValue()::run));
  }
}
