# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

find_program(MCS_EXECUTABLE mcs)
if(NOT MCS_EXECUTABLE)
  message(STATUS "Bindings: no C#, mcs is missing")
  return()
endif()
set(csharp_generated "${CMAKE_CURRENT_BINARY_DIR}/csharp_swig")
set(csharp_folder "${CMAKE_CURRENT_BINARY_DIR}/csharp")
# Failures and texts cross without callbacks into the runtime (SWIG's helpers are process-wide).
jalon_wrapper(jalon_csharp csharp "${csharp_generated}" -namespace Jalon -dllimport jalon_csharp -w314
              -DSWIG_CSHARP_NO_EXCEPTION_HELPER -DSWIG_CSHARP_NO_STRING_HELPER -DSWIG_CSHARP_NO_IMCLASS_STATIC_CONSTRUCTOR)
target_compile_definitions(jalon_csharp PRIVATE SWIG_CSHARP_NO_EXCEPTION_HELPER SWIG_CSHARP_NO_STRING_HELPER)
set_target_properties(jalon_csharp PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${csharp_folder}")
file(GLOB csharp_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/csharp/src/*.cs")
add_custom_command(
  OUTPUT "${csharp_folder}/Jalon.dll"
  COMMAND sh -c "'${MCS_EXECUTABLE}' -target:library -langversion:7 -nologo '-out:${csharp_folder}/Jalon.dll' '${csharp_generated}'/*.cs '${CMAKE_CURRENT_SOURCE_DIR}'/csharp/src/*.cs"
  DEPENDS jalon_csharp ${csharp_sources} VERBATIM)
add_custom_target(jalon_assembly DEPENDS "${csharp_folder}/Jalon.dll")
add_dependencies(bindings jalon_assembly)
