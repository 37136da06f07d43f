// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>
/// Finds the native library: in the folder that the environment variable JALON_NATIVE names, beside the assembly or what it is a copy of, in
/// runtimes/RID/native of the package or of the program, then where the system looks.
/// </summary>
internal static class Loader {
  internal const string Name = "jalon_csharp";

  private static readonly object guard = new object();
  private static volatile bool loaded;

  /// <summary>
  /// True, or an exception. What makes an object and what needs none calls it, and then a method that is not inlined:
  /// Mono looks for the native library when it compiles a method that calls it.
  /// </summary>
  internal static bool Load() {
    if (loaded) return true;
    lock (guard) {
      if (!loaded) LoadNow();
      loaded = true;
    }
    return true;
  }

  private static void LoadNow() {
#if NETCOREAPP3_0_OR_GREATER
    IntPtr library = IntPtr.Zero;
    TryAll(file => NativeLibrary.TryLoad(file, out library));
    NativeLibrary.SetDllImportResolver(typeof(Loader).Assembly,
                                       (name, assembly, path) => name == Name ? library : IntPtr.Zero);
#else
    // A library that is loaded is found by its name.
    TryAll(file => Open(file) != IntPtr.Zero);
#endif
  }

  private static void TryAll(Func<string, bool> load) {
    var tried = new List<string>();
    foreach (string file in Candidates()) {
      if (File.Exists(file) && load(file)) return;
      tried.Add(file);
    }
    if (load(FileName)) return;
    throw new DllNotFoundException("the native library of Jalon cannot be loaded. Tried: " + string.Join(", ", tried) +
                                   ", and " + FileName + " where the system looks" + Reason());
  }

  private static bool IsWindows {
    get { return Path.DirectorySeparatorChar == '\\'; }
  }

  private static string FileName {
    get { return IsWindows ? Name + ".dll" : "lib" + Name + ".so"; }
  }

  private static string RuntimeId {
    get { return (IsWindows ? "win-" : "linux-") + RuntimeInformation.ProcessArchitecture.ToString().ToLowerInvariant(); }
  }

  private static IEnumerable<string> Candidates() {
    string named = Environment.GetEnvironmentVariable("JALON_NATIVE");
    if (!string.IsNullOrEmpty(named)) yield return Path.Combine(named, FileName);
    string packaged = Path.Combine(Path.Combine("runtimes", RuntimeId), Path.Combine("native", FileName));
    foreach (string beside in Folders()) {
      yield return Path.Combine(beside, FileName);
      yield return Path.Combine(beside, packaged);
      yield return Path.Combine(Path.Combine(Path.Combine(beside, ".."), ".."), packaged);
    }
  }

  /// <summary>
  /// Of the assembly: where it was loaded from, and where it came from if the host loads copies; of the program where it is no
  /// file but bytes.
  /// </summary>
  private static IEnumerable<string> Folders() {
    Assembly own = typeof(Loader).GetTypeInfo().Assembly;
    if (string.IsNullOrEmpty(own.Location)) {
      yield return AppContext.BaseDirectory;
      yield break;
    }
    string loaded = Path.GetDirectoryName(own.Location), origin = Path.GetDirectoryName(new Uri(own.CodeBase).LocalPath);
    yield return loaded;
    if (origin != loaded) yield return origin;
  }

#if NETCOREAPP3_0_OR_GREATER
  private static string Reason() {
    return "";
  }
#else
  private const int kNow = 2;  // RTLD_NOW of Linux

  [DllImport("libdl.so.2", EntryPoint = "dlopen")]
  private static extern IntPtr OpenUnix(byte[] file, int flags);

  [DllImport("libdl.so.2", EntryPoint = "dlerror")]
  private static extern IntPtr ErrorUnix();

  [DllImport("kernel32", EntryPoint = "LoadLibraryW", CharSet = CharSet.Unicode, ExactSpelling = true)]
  private static extern IntPtr OpenWindows(string file);

  private static IntPtr Open(string file) {
    return IsWindows ? OpenWindows(file) : OpenUnix(Text.Utf8(file), kNow);
  }

  private static string Reason() {
    return IsWindows ? "" : ": " + Text.Of(ErrorUnix());
  }
#endif
}

}
