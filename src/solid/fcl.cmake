# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# FCL and libccd for the room solid: its files fcl_*.cpp, and no other, are built with them; without them
# fcl_absent.cpp stands in. jalon_solid must exist when it does at all: a test includes this file for its checks alone.
if(JALON_WITH_FCL)
  find_package(ccd REQUIRED CONFIG)
  # libccd is built for single or for double precision, and only its header tells.
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES "${CCD_INCLUDE_DIRS}")
  check_cxx_source_compiles("#include <ccd/vec3.h>
    static_assert(sizeof(ccd_real_t) == sizeof(double), \"single precision\");
    int main() { return 0; }" JALON_CCD_IS_DOUBLE)
  unset(CMAKE_REQUIRED_INCLUDES)
  if(NOT JALON_CCD_IS_DOUBLE)
    message(FATAL_ERROR "libccd in ${CCD_INCLUDE_DIRS} is built for single precision: clearances to 1e-6 m need "
                        "the one for doubles (libccd's option ENABLE_DOUBLE_PRECISION).")
  endif()
endif()

if(TARGET jalon_solid)
  get_target_property(sources jalon_solid SOURCES)
  if(JALON_WITH_FCL)
    list(FILTER sources EXCLUDE REGEX "fcl_absent\\.cpp$")
    # Of FCL's own needs the loader wants what is used, which octomap is not.
    target_link_libraries(jalon_solid PRIVATE fcl ccd)
    target_compile_definitions(jalon_solid PUBLIC JALON_WITH_FCL)
  else()
    list(FILTER sources EXCLUDE REGEX "fcl_(distance|precision)\\.cpp$")
  endif()
  set_target_properties(jalon_solid PROPERTIES SOURCES "${sources}")
endif()
