# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages of what is installed, one a component: `make deb`. Dependencies are found by dpkg-shlibdeps.
# An installed manual page and a change log are compressed, as Debian wants them.
set(EHD_MAINTAINER_ADDRESS "maintainers@ehd.invalid" CACHE STRING "Address of whoever makes the Debian packages")

# ehd_gzip(FROM TO): compressed at configure time, without name and date.
function(ehd_gzip from to)
  execute_process(COMMAND gzip -9nc ${from} OUTPUT_FILE ${to} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

configure_file(cmake/deb/changelog.in changelog @ONLY)
ehd_gzip(${CMAKE_CURRENT_BINARY_DIR}/changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
foreach(package ehd libehd0 libehd-dev)
  install(FILES cmake/deb/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/deb)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The ehd authors <${EHD_MAINTAINER_ADDRESS}>")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "elastohydrodynamic line contacts and roller bearings")
set(about "ehd computes film thickness and pressure of elastohydrodynamic line
contacts, and the load distribution of roller bearings. It states the error of
each number.")
set(CPACK_DEBIAN_EHD_DESCRIPTION "${about}
.
This package has the program and its benchmark cases.")
set(CPACK_DEBIAN_EHD_PACKAGE_SUGGESTS "librsvg2-bin")  # --plot FILE.png
set(CPACK_DEBIAN_LIBEHD0_DESCRIPTION "${about}
.
This package has the library, for programs that call it.")
set(CPACK_DEBIAN_LIBEHD0_PACKAGE_SECTION libs)
# What the packages of other programs depend on, and what tells the loader of a new library.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/deb-control/shlibs "libehd 0 libehd0 (>= ${PROJECT_VERSION})\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/deb-control/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBEHD0_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_BINARY_DIR}/deb-control/shlibs ${CMAKE_CURRENT_BINARY_DIR}/deb-control/triggers)
set(CPACK_DEBIAN_LIBEHD-DEV_DESCRIPTION "${about}
.
This package has the header for C and C++, a module for Fortran, and what
pkg-config and CMake need.")
set(CPACK_DEBIAN_LIBEHD-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBEHD-DEV_PACKAGE_DEPENDS "libehd0 (= ${PROJECT_VERSION})")
foreach(package ehd libehd0 libehd-dev)
  string(TOUPPER ${package} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
endforeach()
include(CPack)
