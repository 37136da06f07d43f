# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# jalon_task_set_memory_limit: the allocations of this library, and of no other, are led through counted_memory_posix.cpp, which
# names each of these. In a static library they would be the host's link to lead.
if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR JALON_STATIC OR NOT CMAKE_SIZEOF_VOID_P EQUAL 8)
  return()
endif()
target_compile_definitions(jalon PRIVATE JALON_COUNTS_MEMORY)
target_link_libraries(jalon PRIVATE ${CMAKE_DL_LIBS})
foreach(symbol malloc calloc realloc free aligned_alloc posix_memalign
        _Znwm _Znam _ZnwmRKSt9nothrow_t _ZnamRKSt9nothrow_t _ZnwmSt11align_val_t _ZnamSt11align_val_t
        _ZdlPv _ZdaPv _ZdlPvm _ZdaPvm _ZdlPvRKSt9nothrow_t _ZdaPvRKSt9nothrow_t
        _ZdlPvSt11align_val_t _ZdaPvSt11align_val_t _ZdlPvmSt11align_val_t _ZdaPvmSt11align_val_t)
  target_link_options(jalon PRIVATE "LINKER:--wrap=${symbol}")
endforeach()
