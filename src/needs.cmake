# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# What Jalon is built with. All that is missing is told at once, with the line that installs it on Debian, before anything
# is built.
set(jalon_missing "")
set(jalon_debian "")

macro(jalon_lacks name debian)
  list(APPEND jalon_missing "${name}")
  list(APPEND jalon_debian ${debian})
endmacro()

# jalon_need(NAME "DEBIAN PACKAGES" PACKAGE ...): find_package(PACKAGE ...), quietly.
macro(jalon_need name debian package)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    jalon_lacks("${name}" "${debian}")
  endif()
endmacro()

# The tools of bindings that were asked for by name; of others those are built whose tools are there.
macro(jalon_need_binding_tools)
  if(JALON_BINDING_LANGUAGES)
    jalon_need("SWIG 4" swig SWIG 4.0)
    jalon_need("Python 3" python3 Python3 COMPONENTS Interpreter)
  endif()
  if("python" IN_LIST JALON_BINDING_LANGUAGES)
    jalon_need("the headers of Python" python3-dev Python3 COMPONENTS Interpreter Development.Module)
  endif()
  if("java" IN_LIST JALON_BINDING_LANGUAGES)
    jalon_need("a Java development kit of 11 or later" default-jdk-headless Java 11 COMPONENTS Development)
    jalon_need("JNI" default-jdk-headless JNI)
  endif()
  if("csharp" IN_LIST JALON_BINDING_LANGUAGES)
    find_program(MCS_EXECUTABLE mcs)
    if(NOT MCS_EXECUTABLE)
      jalon_lacks("the C# compiler mcs" mono-mcs)
    endif()
  endif()
endmacro()

function(jalon_stop_where_missing)
  if(NOT jalon_missing)
    return()
  endif()
  list(JOIN jalon_missing ", " missing)
  list(REMOVE_DUPLICATES jalon_debian)
  list(JOIN jalon_debian " " debian)
  set(without "")
  if(jalon_missing MATCHES "FCL|libccd")
    set(without "\nWithout FCL and libccd it is built by -DJALON_WITH_FCL=OFF: no clearance between two models.")
  endif()
  if(jalon_missing MATCHES "SQLite")
    string(APPEND without "\nWithout SQLite it is built by -DJALON_WITH_SQLITE=OFF: no GeoPackage.")
  endif()
  if(jalon_missing MATCHES "libpng")
    string(APPEND without "\nWithout libpng it is built by -DJALON_WITH_LIBPNG=OFF: no PNG, and drawings and reports without pictures of points.")
  endif()
  message(FATAL_ERROR "Jalon cannot be built, missing: ${missing}. On Debian this installs it:\n"
                      "  apt install ${debian}${without}\n")
endfunction()
