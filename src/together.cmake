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
