// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>
/// An object of the library. Dispose gives its native memory back at once; an object that is not disposed of is
/// finalised. Any order is fine: what an object looks at stays until nothing needs it.
/// </summary>
public abstract class Noun : IDisposable {
  private readonly Box box;

  internal Noun(Box box) {
    this.box = box;
  }

  /// <summary>True after Dispose.</summary>
  public bool IsDisposed {
    get { return box.IsClosed; }
  }

  /// <summary>
  /// Gives the native memory back now. Twice is harmless. BusyException while a call of another thread uses the object,
  /// which then stays as it is.
  /// </summary>
  public void Dispose() {
    if (box.IsClosed) return;
    try {
      Close(box);
    } catch (ObjectDisposedException) {
      return;  // by another thread just now
    }
    DisposeOwned();
    box.Dispose();
  }

  /// <summary>One line: what it is and how much of it there is; never an exception.</summary>
  public override string ToString() {
    string name = GetType().Name;
    if (IsDisposed) return name + " (disposed of)";
    try {
      string about = About();
      return about == "" ? name : name + ": " + about;
    } catch (ObjectDisposedException) {
      return name + " (disposed of)";  // by another thread just now
    } catch (JalonException failure) {
      return name + " (" + failure.Message + ")";
    }
  }

  /// <summary>What ToString says beside the name.</summary>
  internal abstract string About();

  /// <summary>Empties the native box, unless a call uses it.</summary>
  internal virtual void Close(Box box) {}

  /// <summary>What this object made for itself.</summary>
  internal virtual void DisposeOwned() {}

  /// <summary>Also of an object that was disposed of.</summary>
  internal Box BoxUnchecked {
    get { return box; }
  }

  internal Box Live() {
    if (box.IsClosed) throw new ObjectDisposedException(GetType().Name);
    return box;
  }

  /// <summary>The box of an argument; null is none.</summary>
  internal static Box Of(Noun noun) {
    return noun == null ? Box.None : noun.Live();
  }
}

}
