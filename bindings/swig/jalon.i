/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Jalon for all languages. The classes stand in jalon_api.i, generated from the public headers: one a noun, its C handle in
 * a box (handles.h), the functions of the noun as its methods. What differs from language to language is in one file each. */
#ifdef SWIGPYTHON
%module(package="jalon") native
#endif
#ifdef SWIGJAVA
%module Jalon
#endif
#ifdef SWIGCSHARP
%module Library
#endif

%{
#include "jalon_calls.h"
using namespace jalon_binding;
%}

%include <stdint.i>

#ifdef SWIGPYTHON
%include "python.i"
#endif
#ifdef SWIGJAVA
%include "java.i"
#endif
#ifdef SWIGCSHARP
%include "csharp.i"
#endif

%nodefaultctor Array;
class Array {
 public:
  ~Array();
  uint64_t count() const;
  uint32_t components() const;
  int32_t type() const;
  uint64_t stride_bytes() const;
};
typedef Array Numbers;
typedef Array Octets;

class Gauge {
 public:
  Gauge();
  ~Gauge();
  void add_box(const ArrayIn* size, const ArrayIn* frame = NULL);
  void add_sphere(double radius_m, const ArrayIn* frame = NULL);
  void add_cylinder(double radius_m, double length_m, const ArrayIn* frame = NULL);
  void add_hull(const ArrayIn* points, const ArrayIn* frame = NULL);
  uint64_t count() const;
};

class Targets {
 public:
  Targets();
  ~Targets();
  void add(const char* name, const ArrayIn* xyz, const ArrayIn* covariance = NULL);
  uint64_t count() const;
};

class CloudList {
 public:
  CloudList();
  ~CloudList();
  void add(Cloud* cloud);
  uint64_t count() const;
};

%{
/** Handles that the objects of this process hold; tests watch that it comes back to zero. */
static int64_t live_handle_count() { return live_handles(); }
%}
int64_t live_handle_count();

%include "jalon_api.i"
