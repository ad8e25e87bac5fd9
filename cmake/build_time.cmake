# SPDX-License-Identifier: GPL-3.0-or-later
# What keeps the build short: large headers are parsed once for several targets, several files are compiled at once, and
# what computes little is optimised little.
option(EHD_PRECOMPILE "Parse the largest headers once for several targets" ON)
option(EHD_UNITY "Compile several files of a room at once" ON)

# gcc frees memory only from 800 MB on, not from 128. That saves 5 to 10 % of the time of the larger files. The largest
# then takes 1.1 GB. It changes no code, so that `ehd --version` need not name it.
cmake_host_system_information(RESULT memory_MB QUERY TOTAL_PHYSICAL_MEMORY)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory_of_a_core_MB "${memory_MB} / ${cores}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND memory_of_a_core_MB GREATER 1500)
  add_compile_options(--param=ggc-min-heapsize=800000)
endif()

# Internal.
function(ehd_precompile_options target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # gcc 12 warns about strings joined by its own library (PR 105651). From a precompiled header it does not know that
    # the code is the library's, and does not suppress the warning.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# ehd_precompile(TARGET HEADERS...): the headers are parsed once for all files of the target.
function(ehd_precompile target)
  if(EHD_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    ehd_precompile_options(${target})
  endif()
endfunction()

# ehd_reuse_precompiled(TARGET OWNER): the precompiled headers of OWNER serve TARGET as well. Both must be compiled with
# the same options and definitions: a definition for one file belongs to that file, not to the target.
function(ehd_reuse_precompiled target owner)
  if(EHD_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    ehd_precompile_options(${target})
  endif()
endfunction()

# ehd_optimise_little(TARGET): for code that writes text or calls solvers, and computes little itself. -Og takes 60 % of
# the time of -O3. The linker keeps one copy of each inline function, Eigen's above all, and might keep the slow one.
# So a target that includes Eigen needs ehd_rooms_first where it is linked.
function(ehd_optimise_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # gcc leaves vzeroupper out at -Og otherwise. Where the wide registers are not cleared, processors with AVX-512 take
    # 130 ns for a logarithm of libm, which else takes 4.
    target_compile_options(${target} PRIVATE -fexpensive-optimizations)
  endif()
endfunction()

# ehd_optimise_less(TARGET): for code that reads and writes text row by row. -O1 takes 60 % of the time of -O3 too.
# Sweeps of dry contacts, which do little else, then take 1.05 times the instructions; with -Og they take 1.4 times. As
# above for targets that include Eigen.
function(ehd_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# ehd_rooms_first(TARGET ROOMS...): the linker keeps the first copy of an inline function that several objects contain.
# Here the archives of the rooms come first, whole. So what the rooms contain runs as they compiled it, at -O3.
function(ehd_rooms_first target)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE archives)
  list(JOIN archives " " archives)
  target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive ${archives} -Wl,--no-whole-archive")
endfunction()

# ehd_unity(TARGET BATCH): the compiler gets BATCH files of the target at once, and makes what they share once, which
# halves the time. Names in their anonymous namespaces must then differ. For the rooms of many small files that use the
# same large headers. The rooms that compute are compiled file by file. Tools that look for each file in
# compile_commands.json need EHD_UNITY=OFF.
function(ehd_unity target batch)
  if(EHD_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()
