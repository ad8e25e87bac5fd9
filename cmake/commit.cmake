# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=folder -DHEADER=file -P commit.cmake: the commit of the tree that is being built, its year, and whether
# the tree was changed since. In a tarball of `make dist` commit and day stand in cmake/commit.txt; else they are empty
# outside git. Written only where it differs, so that nothing is built again for nothing.
cmake_minimum_required(VERSION 3.25)  # policies of its own: it runs apart from the build

function(ask result)
  execute_process(COMMAND git -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE answer ERROR_QUIET RESULT_VARIABLE failed
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    set(answer "")
  endif()
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

ask(top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE} source)
set(commit "")
set(dirty false)
if(top STREQUAL source)  # a copy within another project's tree has no commit of its own
  ask(commit rev-parse HEAD)
  ask(day show --no-patch --format=%cs HEAD)
  ask(changes status --porcelain)
  if(NOT changes STREQUAL "")
    set(dirty true)
  endif()
else()
  file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/commit.txt commit REGEX "^[0-9a-f]+$")
  file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/commit.txt day REGEX "^[0-9]+-")
endif()
string(REGEX MATCH "^[0-9]+" year "${day}")
file(CONFIGURE OUTPUT ${HEADER} CONTENT
     "#pragma once

#define EHD_COMMIT \"@commit@\"
#define EHD_COMMIT_YEAR \"@year@\"
#define EHD_COMMIT_DIRTY @dirty@
" @ONLY)
