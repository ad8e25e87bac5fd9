# SPDX-License-Identifier: GPL-3.0-or-later
# A target with the property EHD_STATIC_LIBRARIES is linked with static FFTW, GSL and xxHash. The program has it,
# because loading the shared ones takes a fifth of a short run. libehd.so does not: Debian's static libraries cannot
# become part of a shared one.
option(EHD_STATIC "Link FFTW, GSL and xxHash into the program (on for local builds, off for packages)" ${EHD_NATIVE})

# ehd_library(NAME SHARED BESIDE FILES...): makes the target NAME. It stands for the static FILES, or for SHARED, a list
# of targets or files. The static files are looked for in the folder of the file BESIDE. If one of them is missing,
# SHARED serves.
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
