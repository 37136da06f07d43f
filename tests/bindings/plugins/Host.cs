// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.IO;
using System.Reflection;

/// <summary>A host that knows nothing of Jalon: Host MANNER FOLDER ... loads the Plugin.dll of each folder and prints what it says.</summary>
static class Host {
  static string Call(Assembly plugin) {
    return (string)plugin.GetType("Plugin").GetMethod("Work").Invoke(null, null);
  }

  static string From(string folder) {
    return Call(Assembly.LoadFrom(Path.Combine(folder, "Plugin.dll")));
  }

  public sealed class Remote : MarshalByRefObject {
    public string Work(string folder) {
      return From(folder);
    }
  }

  /// <summary>A domain of its own, which is unloaded; shadow: its assemblies run as copies in a cache.</summary>
  static string InDomain(string folder, bool shadow) {
    var setup = new AppDomainSetup {ApplicationBase = folder, ApplicationName = "plugin", CachePath = Path.Combine(folder, "cache"),
                                    ShadowCopyFiles = shadow ? "true" : "false"};
    AppDomain domain = AppDomain.CreateDomain("plugin", null, setup);
    try {
      return ((Remote)domain.CreateInstanceFromAndUnwrap(typeof(Remote).Assembly.Location, typeof(Remote).FullName)).Work(folder);
    } finally {
      AppDomain.Unload(domain);
    }
  }

  static string FromBytes(string folder) {
    AppDomain.CurrentDomain.AssemblyResolve += (sender, wanted) => Assembly.Load(File.ReadAllBytes(Path.Combine(folder, "Jalon.dll")));
    return Call(Assembly.Load(File.ReadAllBytes(Path.Combine(folder, "Plugin.dll"))));
  }

  static void Main(string[] arguments) {
    for (int i = 1; i < arguments.Length; ++i) {
      string folder = arguments[i];
      Console.WriteLine(arguments[0] == "from" ? From(folder) : arguments[0] == "domain" ? InDomain(folder, false)
                        : arguments[0] == "shadow" ? InDomain(folder, true) : FromBytes(folder));
    }
  }
}
