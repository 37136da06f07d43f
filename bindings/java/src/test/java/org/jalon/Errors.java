// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.util.Map;

/** Failures as exceptions. */
final class Errors {
  private Errors() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("errors__one_class_a_status", Errors::classes);
    all.put("errors__use_after_close_and_double_close", Errors::closed);
    all.put("errors__closed_arguments", Errors::closedArguments);
    all.put("errors__the_loader_names_this_platform", Errors::platform);
    all.put("errors__a_second_class_loader_has_its_own_library", Errors::secondLoader);
  }

  private static void classes() throws Exception {
    same(Jalon.ERROR_NOT_FOUND, thrown(NotFoundException.class, () -> Segmenter.create("none")).status());
    same(Jalon.ERROR_NOT_FOUND, thrown(NotFoundException.class, () -> Cloud.read("/no/such.las")).status());
    final java.nio.file.Path bad = java.nio.file.Files.createTempFile(null, ".las");
    java.nio.file.Files.write(bad, new byte[] {'n', 'o'});
    thrown(FormatException.class, () -> Cloud.read(bad.toString()));
    java.nio.file.Files.delete(bad);
    try (Cloud none = Cloud.create(new double[0], 0)) {
      thrown(InsufficientDataException.class, none::bounds);
      same(Jalon.ERROR_IO, thrown(FileException.class, () -> none.write("/no/such/folder/a.las")).status());
    }
    for (int status = -12; status < 0; ++status) {
      final JalonException made = JalonException.of(status, new byte[] {'x'});
      same(status, made.status());
      same("x", made.getMessage());
    }
    thrown(JalonException.class, () -> Jalon.sceneCreate(new NormalsParams()));
  }

  private static void closed() {
    final Cloud cloud = Cloud.create(new double[] {1, 2, 3}, 0);
    expect(!cloud.isClosed(), "open at first");
    cloud.close();
    cloud.close();
    expect(cloud.isClosed(), "closed then");
    expect(thrown(ClosedException.class, cloud::count).getMessage().contains("cloud"), "the noun");
    thrown(ClosedException.class, cloud::points);
  }

  private static void closedArguments() {
    final Cloud cloud = Cloud.create(new double[] {1, 2, 3}, 0);
    final Task task = Task.create();
    final NormalsParams options = new NormalsParams();
    try (Segmenter segmenter = Segmenter.create("ransac"); Cloud open = Cloud.create(new double[] {1, 2, 3}, 0)) {
      cloud.close();
      thrown(ClosedException.class, () -> segmenter.run(cloud));
      same("cloud is null", thrown(InvalidArgumentException.class, () -> segmenter.run(null)).getMessage());
      options.close();
      thrown(ClosedException.class, () -> open.computeNormals(options));
      task.close();
      thrown(ClosedException.class, () -> open.prepare(task));
      thrown(ClosedException.class, () -> Cloud.shareOctree(java.util.List.of(open, cloud)));
    }
  }

  /** As in an application server: the same library, unpacked anew, is another file to the virtual machine. */
  private static void secondLoader() throws Exception {
    final java.net.URL[] here = {Jalon.class.getProtectionDomain().getCodeSource().getLocation()};
    try (java.net.URLClassLoader loader = new java.net.URLClassLoader(here, ClassLoader.getPlatformClassLoader())) {
      final Class<?> other = Class.forName("org.jalon.Jalon", true, loader);
      expect(other != Jalon.class, "the same class");
      same(Jalon.version(), other.getMethod("version").invoke(null));
    }
  }

  private static void platform() {
    expect(NativeLibrary.platform().matches("(linux|windows|macos)-(x86_64|aarch64)"), NativeLibrary.platform());
    expect(Jalon.version().matches("\\d+\\.\\d+\\.\\d+.*"), Jalon.version());
  }
}
