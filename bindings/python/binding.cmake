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
