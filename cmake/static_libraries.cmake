# SPDX-License-Identifier: GPL-3.0-or-later
# A program with the property EHD_STATIC_LIBRARIES holds FFTW, GSL and xxHash: to load them takes a fifth of a short
# run. A shared library cannot hold them. Where a static one is not installed, the shared one serves.

# ehd_library(NAME SHARED FILES...): the target NAME is one of the two. SHARED: a list of targets or files.
function(ehd_library name shared)
  set(static)
  foreach(file ${ARGN})
    find_library(EHD_STATIC_${file} ${file} NO_CACHE)
    if(NOT EHD_STATIC_${file})
      set(static ${shared})
      break()
    endif()
    list(APPEND static ${EHD_STATIC_${file}})
  endforeach()
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE
    "$<IF:$<BOOL:$<TARGET_PROPERTY:EHD_STATIC_LIBRARIES>>,${static},${shared}>")
endfunction()

ehd_library(ehd_fftw "${FFTW_THREADS};PkgConfig::FFTW" libfftw3_threads.a libfftw3.a)
ehd_library(ehd_gsl "GSL::gsl;GSL::gslcblas" libgsl.a libgslcblas.a)
ehd_library(ehd_xxhash PkgConfig::XXHASH libxxhash.a)
