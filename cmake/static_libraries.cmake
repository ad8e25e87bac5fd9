# SPDX-License-Identifier: GPL-3.0-or-later
# A program with the property EHD_STATIC_LIBRARIES holds FFTW, GSL and xxHash: to load them takes a fifth of a short
# run. libehd.so takes the shared ones, because Debian's static ones are not made for shared libraries.
option(EHD_STATIC "Link FFTW, GSL and xxHash into the program (on for local builds, off for packages)" ${EHD_NATIVE})

# ehd_library(NAME SHARED BESIDE FILES...): the target NAME is SHARED, a list of targets or files, or the static FILES
# in the folder of the file BESIDE. Where one of them is missing, the shared ones serve.
function(ehd_library name shared beside)
  get_filename_component(folder ${beside} DIRECTORY)
  set(static)
  foreach(file ${ARGN})
    find_library(found_${file} ${file} PATHS ${folder} NO_DEFAULT_PATH NO_CACHE)
    if(NOT found_${file})
      set(static ${shared})
      break()
    endif()
    list(APPEND static ${found_${file}})
  endforeach()
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE
    "$<IF:$<BOOL:$<TARGET_PROPERTY:EHD_STATIC_LIBRARIES>>,${static},${shared}>")
endfunction()

ehd_library(ehd_fftw "${FFTW_THREADS};PkgConfig::FFTW" ${FFTW_THREADS} libfftw3_threads.a libfftw3.a)
ehd_library(ehd_gsl "GSL::gsl;GSL::gslcblas" ${GSL_LIBRARY} libgsl.a libgslcblas.a)
ehd_library(ehd_xxhash PkgConfig::XXHASH ${XXHASH_LINK_LIBRARIES} libxxhash.a)
