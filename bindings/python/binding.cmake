# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

if(NOT Python3_Development.Module_FOUND)
  message(STATUS "Bindings: no Python, its headers are missing")
  return()
endif()
set(python_package "${CMAKE_CURRENT_BINARY_DIR}/python/jalon")
jalon_wrapper(jalon_python python "${CMAKE_CURRENT_BINARY_DIR}/python_swig")
target_link_libraries(jalon_python PRIVATE Python3::Module)
set_target_properties(jalon_python PROPERTIES PREFIX "" OUTPUT_NAME _native LIBRARY_OUTPUT_DIRECTORY "${python_package}")

# Java's and C#'s natives have libjalon beside them in the build too.
if(JALON_INSTALLED AND UNIX)
  add_custom_command(TARGET jalon_python POST_BUILD VERBATIM
                     COMMAND "${CMAKE_COMMAND}" -E create_symlink "$<TARGET_FILE:jalon::jalon>"
                             "${python_package}/$<TARGET_SONAME_FILE_NAME:jalon::jalon>")
endif()

# The package as it is installed, in the build tree: PYTHONPATH=build/.../bindings/python is enough to use it.
file(GLOB python_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/python/jalon/*")
set(python_stamp "${CMAKE_CURRENT_BINARY_DIR}/python.stamp")
add_custom_command(
  OUTPUT "${python_stamp}"
  COMMAND "${CMAKE_COMMAND}" -E copy_if_different ${python_sources} "${generated}/_api.py" "${generated}/_api.pyi" "${generated}/_columns.py"
          "${python_package}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${python_stamp}"
  DEPENDS ${python_sources} ${generated_files} jalon_python VERBATIM)
add_custom_target(jalon_python_package DEPENDS "${python_stamp}")
add_dependencies(bindings jalon_python_package)

# The wheel: the package with the library beside the extension, which looks for it there.
install(TARGETS jalon_python LIBRARY DESTINATION jalon COMPONENT python EXCLUDE_FROM_ALL)
install(FILES ${python_sources} "${generated}/_api.py" "${generated}/_api.pyi" "${generated}/_columns.py" DESTINATION jalon COMPONENT python
        EXCLUDE_FROM_ALL)
set(python_natives "${CMAKE_CURRENT_BINARY_DIR}/python_natives")
jalon_natives(python_natives "${python_natives}" "${CMAKE_CURRENT_BINARY_DIR}/python_natives.txt")
# The command line tool, for those who have pip alone: of this build, or of the Jalon that is installed.
set(python_tool "")
if(TARGET jalon_cli)
  set(python_tool jalon_cli)
  set(python_tool_file "$<TARGET_FILE:jalon_cli>")
elseif(JALON_INSTALLED)
  get_target_property(jalon_location jalon::jalon LOCATION)
  get_filename_component(jalon_folder "${jalon_location}" DIRECTORY)
  find_program(JALON_TOOL jalon HINTS "${jalon_folder}/.." "${jalon_folder}/../.." PATH_SUFFIXES bin NO_DEFAULT_PATH)
  if(JALON_TOOL)
    set(python_tool "${JALON_TOOL}")
    set(python_tool_file "${JALON_TOOL}")
  endif()
endif()
set(python_tool_copy "")
if(python_tool)
  set(python_tool_copy "${python_natives}/bin/jalon${CMAKE_EXECUTABLE_SUFFIX}")
  set(look_above "")
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND PATCHELF_EXECUTABLE)
    set(look_above COMMAND "${PATCHELF_EXECUTABLE}" --force-rpath --set-rpath "$ORIGIN/.." "${python_tool_copy}")
  endif()
  add_custom_command(
    OUTPUT "${python_tool_copy}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${python_natives}/bin"
    COMMAND "${CMAKE_COMMAND}" -E copy "${python_tool_file}" "${python_tool_copy}"
    ${look_above}
    DEPENDS ${python_tool} "${natives_stamp}" VERBATIM)
else()
  message(STATUS "Bindings: the Python package has no command jalon, the tool is missing")
endif()
add_custom_target(jalon_python_natives DEPENDS "${natives_stamp}" ${python_tool_copy})
add_dependencies(bindings jalon_python_natives)
install(DIRECTORY "${python_natives}/" DESTINATION jalon COMPONENT python EXCLUDE_FROM_ALL USE_SOURCE_PERMISSIONS)
