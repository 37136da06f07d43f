// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Finds and loads the native library: where the system property {@code jalon.library.path} says, else in the jar under
 * native/(os)-(architecture)/, else in java.library.path. When none works the error lists what was tried.
 */
final class NativeLibrary {
  private static final String NAME = "jalon_java";
  private static final String PREFIX = "jalon-native-";
  private final List<String> tried = new ArrayList<>();

  private NativeLibrary() {}

  static void load() {
    final NativeLibrary library = new NativeLibrary();
    if (!library.fromProperty() && !library.fromJar() && !library.fromSystem()) {
      throw new UnsatisfiedLinkError("Jalon's native library was not found; tried:" + String.join("", library.tried));
    }
  }

  /** E.g. linux-x86_64, windows-x86_64, macos-aarch64. */
  static String platform() {
    final String os = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    final String arch = System.getProperty("os.arch").toLowerCase(Locale.ROOT);
    return (os.startsWith("windows") ? "windows" : os.startsWith("mac") ? "macos" : os.replace(' ', '_')) + "-"
        + (arch.equals("amd64") || arch.equals("x64") ? "x86_64" : arch.equals("arm64") ? "aarch64" : arch);
  }

  private boolean fromProperty() {
    final String given = System.getProperty("jalon.library.path");
    if (given == null) {
      tried.add("\n  the system property jalon.library.path: not set");
      return false;
    }
    final Path path = Paths.get(given);
    return loaded(Files.isDirectory(path) ? path.resolve(System.mapLibraryName(NAME)) : path, "jalon.library.path");
  }

  /** Unpacks what native/PLATFORM/files.txt names, and the wrapper, into a folder of this process alone. */
  private boolean fromJar() {
    final String folder = "/native/" + platform() + "/";
    try (InputStream list = NativeLibrary.class.getResourceAsStream(folder + "files.txt")) {
      if (list == null) {
        tried.add("\n  the jar: it has no " + folder);
        return false;
      }
      sweep();
      final Path to = Files.createTempDirectory(PREFIX + ProcessHandle.current().pid() + "-");
      final String wrapper = System.mapLibraryName(NAME);
      final String names = new String(list.readAllBytes(), java.nio.charset.StandardCharsets.UTF_8) + ' ' + wrapper;
      try {
        for (String name : names.trim().split("\\s+")) {
          try (InputStream file = NativeLibrary.class.getResourceAsStream(folder + name)) {
            if (file == null) {
              tried.add("\n  the jar: " + folder + name + " is missing");
              return false;
            }
            Files.copy(file, to.resolve(name));
          }
        }
        return loaded(to.resolve(wrapper), "the jar");
      } finally {
        remove(to); // where files in use cannot be removed (Windows) the next start does it
      }
    } catch (IOException | UncheckedIOException error) {
      tried.add("\n  the jar: it cannot be unpacked to " + System.getProperty("java.io.tmpdir") + ": " + error);
      return false;
    }
  }

  private boolean fromSystem() {
    try {
      System.loadLibrary(NAME);
      return true;
    } catch (UnsatisfiedLinkError error) {
      tried.add("\n  java.library.path: " + error.getMessage());
      return false;
    }
  }

  private boolean loaded(Path path, String where) {
    try {
      System.load(path.toAbsolutePath().toString());
      return true;
    } catch (UnsatisfiedLinkError error) {
      tried.add("\n  " + where + ": " + error.getMessage());
      return false;
    }
  }

  /** Removes the folders of processes that are gone. */
  private static void sweep() throws IOException {
    final Path tmp = Paths.get(System.getProperty("java.io.tmpdir"));
    try (DirectoryStream<Path> folders = Files.newDirectoryStream(tmp, PREFIX + "*")) {
      for (Path folder : folders) {
        final String[] parts = folder.getFileName().toString().substring(PREFIX.length()).split("-");
        if (parts[0].matches("\\d{1,18}") && !ProcessHandle.of(Long.parseLong(parts[0])).isPresent()) {
          remove(folder);
        }
      }
    }
  }

  private static void remove(Path folder) {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
      for (Path file : files) {
        Files.deleteIfExists(file);
      }
      Files.deleteIfExists(folder);
    } catch (IOException stillInUse) {
      folder.toFile().deleteOnExit();
    }
  }
}
