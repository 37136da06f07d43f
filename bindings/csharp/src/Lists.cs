// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>The convex pieces of a gauge. frame: T_gauge_piece, 3 x 4 or 4 x 4; none = identity.</summary>
public sealed class Gauge : Noun {
  [DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_Gauge")]
  private static extern void DeleteGauge(IntPtr gauge);

  private sealed class NativeBox : Box {
    internal NativeBox(IntPtr gauge) : base(gauge, 0) {}
    protected override void Delete(IntPtr gauge) {
      DeleteGauge(gauge);
    }
  }

  /// <summary>A gauge without pieces.</summary>
  public Gauge() : base(new NativeBox(Loader.Load() ? Made() : IntPtr.Zero)) {}

  [MethodImpl(MethodImplOptions.NoInlining)]
  private static IntPtr Made() {
    IntPtr made = LibraryPINVOKE.new_Gauge();
    Failure.Check();
    return made;
  }

  /// <summary>A box of these edge lengths (m), its centre in the frame's origin.</summary>
  public void AddBox(ArrayArgument size, ArrayArgument frame = default(ArrayArgument)) {
    using (var self_ = new Held(Live()))
    using (var size_ = new Pinned(size, "size", true))
    using (var frame_ = new Pinned(frame, "frame", false)) {
      LibraryPINVOKE.Gauge_add_box(self_.Pointer, size_.Pointer, frame_.Pointer);
    }
    Failure.Check();
  }

  /// <summary>A ball around the frame's origin.</summary>
  public void AddSphere(double radiusM, ArrayArgument frame = default(ArrayArgument)) {
    using (var self_ = new Held(Live()))
    using (var frame_ = new Pinned(frame, "frame", false)) {
      LibraryPINVOKE.Gauge_add_sphere(self_.Pointer, radiusM, frame_.Pointer);
    }
    Failure.Check();
  }

  /// <summary>A cylinder along the frame's z, its centre in the origin.</summary>
  public void AddCylinder(double radiusM, double lengthM, ArrayArgument frame = default(ArrayArgument)) {
    using (var self_ = new Held(Live()))
    using (var frame_ = new Pinned(frame, "frame", false)) {
      LibraryPINVOKE.Gauge_add_cylinder(self_.Pointer, radiusM, lengthM, frame_.Pointer);
    }
    Failure.Check();
  }

  /// <summary>The convex hull of points (n, 3).</summary>
  public void AddHull(ArrayArgument points, ArrayArgument frame = default(ArrayArgument)) {
    using (var self_ = new Held(Live()))
    using (var points_ = new Pinned(points, "points", true))
    using (var frame_ = new Pinned(frame, "frame", false)) {
      LibraryPINVOKE.Gauge_add_hull(self_.Pointer, points_.Pointer, frame_.Pointer);
    }
    Failure.Check();
  }

  /// <summary>Number of pieces.</summary>
  public long Count {
    get {
      using (var self_ = new Held(Live())) return Number.Of(LibraryPINVOKE.Gauge_count(self_.Pointer));
    }
  }

  internal override string About() {
    return Count == 1 ? "1 piece" : Count + " pieces";
  }
}

/// <summary>Points known in one frame, for a registration.</summary>
public sealed class Targets : Noun {
  [DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_Targets")]
  private static extern void DeleteTargets(IntPtr targets);

  private sealed class NativeBox : Box {
    internal NativeBox(IntPtr targets) : base(targets, 0) {}
    protected override void Delete(IntPtr targets) {
      DeleteTargets(targets);
    }
  }

  /// <summary>No targets yet.</summary>
  public Targets() : base(new NativeBox(Loader.Load() ? Made() : IntPtr.Zero)) {}

  [MethodImpl(MethodImplOptions.NoInlining)]
  private static IntPtr Made() {
    IntPtr made = LibraryPINVOKE.new_Targets();
    Failure.Check();
    return made;
  }

  /// <summary>One target; name may be null; covariance: 3 x 3 (m2), none = parameter sigma_m on each axis.</summary>
  public void Add(string name, ArrayArgument xyz, ArrayArgument covariance = default(ArrayArgument)) {
    using (var self_ = new Held(Live()))
    using (var name_ = new NativeText(name))
    using (var xyz_ = new Pinned(xyz, "xyz", true))
    using (var covariance_ = new Pinned(covariance, "covariance", false)) {
      LibraryPINVOKE.Targets_add(self_.Pointer, name_.Pointer, xyz_.Pointer, covariance_.Pointer);
    }
    Failure.Check();
  }

  /// <summary>One target without a name: found by its distances to the others.</summary>
  public void Add(ArrayArgument xyz) {
    Add(null, xyz);
  }

  internal override string About() {
    return "" + Count;
  }

  /// <summary>Number of targets.</summary>
  public long Count {
    get {
      using (var self_ = new Held(Live())) return Number.Of(LibraryPINVOKE.Targets_count(self_.Pointer));
    }
  }
}

/// <summary>Several clouds as one argument.</summary>
internal sealed class CloudList : Noun {
  internal override string About() {
    return "";
  }

  [DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_CloudList")]
  private static extern void DeleteCloudList(IntPtr list);

  private sealed class NativeBox : Box {
    internal NativeBox(IntPtr list) : base(list, 0) {}
    protected override void Delete(IntPtr list) {
      DeleteCloudList(list);
    }
  }

  internal CloudList(IEnumerable<Cloud> clouds, string name)
      : base(new NativeBox(LibraryPINVOKE.new_CloudList())) {
    Failure.Check();
    if (clouds == null) throw new InvalidArgumentException(name + " must not be null");
    foreach (Cloud cloud in clouds) {
      using (var self_ = new Held(Live()))
      using (var cloud_ = new Held(Of(cloud))) LibraryPINVOKE.CloudList_add(self_.Pointer, cloud_.Pointer);
      Failure.Check();
    }
  }
}

}
