# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

find_program(MCS_EXECUTABLE mcs)
if(NOT MCS_EXECUTABLE)
  message(STATUS "Bindings: no C#, mcs is missing")
  return()
endif()
set(csharp_generated "${CMAKE_CURRENT_BINARY_DIR}/csharp_swig")
set(csharp_api "${CMAKE_CURRENT_BINARY_DIR}/csharp_api")
set(csharp_package "${CMAKE_CURRENT_BINARY_DIR}/csharp") # the folders of the NuGet package
set(csharp_native "${csharp_package}/runtimes/linux-x64/native")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  set(csharp_native "${csharp_package}/runtimes/linux-arm64/native")
endif()

# Only the P/Invoke class is taken from SWIG. Failures and texts cross without callbacks into the runtime (SWIG's helpers are
# process-wide).
jalon_wrapper(jalon_csharp csharp "${csharp_generated}" -noproxy -namespace Jalon -dllimport jalon_csharp -w314
              -DSWIG_CSHARP_NO_EXCEPTION_HELPER -DSWIG_CSHARP_NO_STRING_HELPER -DSWIG_CSHARP_NO_IMCLASS_STATIC_CONSTRUCTOR)
target_compile_definitions(jalon_csharp PRIVATE SWIG_CSHARP_NO_EXCEPTION_HELPER SWIG_CSHARP_NO_STRING_HELPER)
set_target_properties(jalon_csharp PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${csharp_native}" BUILD_WITH_INSTALL_RPATH ON)
if(NOT WIN32) # by its name Loader finds it again
  target_link_options(jalon_csharp PRIVATE "LINKER:-soname,libjalon_csharp.so")
endif()
jalon_natives(csharp_natives "${csharp_native}" "${CMAKE_CURRENT_BINARY_DIR}/csharp_natives.txt")

set(csharp_emitted "${csharp_api}/Api.cs" "${csharp_api}/Options.cs")
add_custom_command(
  OUTPUT ${csharp_emitted}
  COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/generator/emit_csharp.py" "${csharp_api}" "${params_json}"
  DEPENDS "${params_json}" ${generator} ${public_headers} VERBATIM)
file(GLOB csharp_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/csharp/src/*.cs")
# One assembly a framework of the package; spans are no part of .NET Standard 2.0.
set(csharp_assemblies)
set(spans)
foreach(framework netstandard2.0 netstandard2.1)
  set(folder "${csharp_package}/lib/${framework}")
  add_custom_command(
    OUTPUT "${folder}/Jalon.dll"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
    COMMAND "${MCS_EXECUTABLE}" -nologo -target:library -unsafe -optimize -langversion:7.2 -warnaserror -nowarn:1573
            ${spans} "-doc:${folder}/Jalon.xml" "-out:${folder}/Jalon.dll"
            ${csharp_emitted} ${csharp_sources} "${csharp_generated}/LibraryPINVOKE.cs"
    DEPENDS jalon_csharp ${csharp_sources} ${csharp_emitted} VERBATIM)
  list(APPEND csharp_assemblies "${folder}/Jalon.dll")
  set(spans -define:JALON_SPANS)
endforeach()

# The other files of the package, and all of them as one.
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/csharp/Jalon.nuspec.in" "${csharp_package}/Jalon.nuspec" @ONLY)
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/csharp/README.md" "${csharp_package}/README.md" COPYONLY)
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/csharp/Jalon.targets" "${csharp_package}/build/netstandard2.0/Jalon.targets" COPYONLY)
configure_file("${PROJECT_SOURCE_DIR}/LICENSE" "${csharp_package}/LICENSE" COPYONLY)
configure_file("${third_party}" "${csharp_package}/THIRD-PARTY-LICENSES.txt" COPYONLY)
set(csharp_nupkg "${CMAKE_CURRENT_BINARY_DIR}/Jalon.${PROJECT_VERSION}.nupkg")
add_custom_command(
  OUTPUT "${csharp_nupkg}"
  COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/csharp/pack.py" "${csharp_package}" "${csharp_nupkg}"
  DEPENDS ${csharp_assemblies} jalon_csharp "${natives_stamp}" "${CMAKE_CURRENT_SOURCE_DIR}/csharp/pack.py" "${csharp_package}/Jalon.nuspec"
          "${csharp_package}/README.md" "${csharp_package}/build/netstandard2.0/Jalon.targets" VERBATIM)
add_custom_target(jalon_assembly DEPENDS ${csharp_assemblies} "${csharp_nupkg}")
add_dependencies(bindings jalon_assembly)
