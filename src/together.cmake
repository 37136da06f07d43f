# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# The files of a folder are compiled as one, `most` at a time, which reads the headers once and takes 0.6 of the time; so
# the names in the anonymous namespaces of a folder differ. Those that match `alone` are compiled by themselves.
function(jalon_folders_together target most alone)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources EXCLUDE REGEX "^\\$<")
  set(last "")
  foreach(source IN LISTS sources)
    if(alone AND source MATCHES "${alone}")
      continue()
    endif()
    get_filename_component(folder "${source}" DIRECTORY)
    if(NOT folder STREQUAL last)
      set(count 0)
      set(last "${folder}")
    endif()
    file(RELATIVE_PATH group "${CMAKE_CURRENT_SOURCE_DIR}" "${folder}")
    math(EXPR part "${count} / ${most}")
    math(EXPR count "${count} + 1")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}_${part}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${JALON_UNITY} UNITY_BUILD_MODE GROUP)
  if(JALON_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # It takes the files of a folder for headers, where a member of a type without linkage would be a mistake.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# Headers of the standard library that most files see are read once for all targets of a `kind`, which agree in optimisation
# and in how their code can be moved: 0.2 to 0.8 s of each compilation. The first target of the kind reads them, and `ARGN` besides.
# Not without JALON_UNITY, where each file proves that it includes what it uses; and GCC alone takes what was read with
# other macros on the command line.
function(jalon_headers_read_once target kind)
  if(NOT JALON_UNITY OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CMAKE_HOST_WIN32
     OR CMAKE_CROSSCOMPILING)
    return()
  endif()
  get_property(owner GLOBAL PROPERTY jalon_headers_of_${kind})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    return()
  endif()
  set_property(GLOBAL PROPERTY jalon_headers_of_${kind} ${target})
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <bit> <charconv> <cmath> <cstdint> <cstring> <functional>
                            <limits> <map> <memory> <numbers> <numeric> <optional> <set> <span> <string> <string_view>
                            <tuple> <unordered_map> <utility> <vector> ${ARGN})
endfunction()
