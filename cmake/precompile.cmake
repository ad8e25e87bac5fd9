# SPDX-License-Identifier: GPL-3.0-or-later
# Headers that nearly every file of a target reads anyway are parsed once: Eigen and the JSON library take 3 s a file.
option(EHD_PRECOMPILE "Parse the largest headers once for each target" ON)
function(ehd_precompile target)
  if(NOT EHD_PRECOMPILE)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Precompiled, gcc 12 no longer sees that what it warns of is its own library's: strings that are joined (PR 105651).
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()
