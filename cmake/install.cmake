# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts under a prefix, by Debian package: ehd (program and cases), libehd0, libehd-dev. Nothing
# there names the prefix or the source tree, so that an installed tree can be moved.
include(CMakePackageConfigHelpers)

install(TARGETS ehd_program RUNTIME COMPONENT ehd)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/ehd COMPONENT ehd MESSAGE_NEVER)  # 500 files

# Made by the program when it is installed: what its shell completes, and its manual pages where help2man is there.
install(CODE "set(EHD_PROGRAM \"$<TARGET_FILE:ehd_program>\")
set(EHD_SHARE \"${CMAKE_INSTALL_DATADIR}\")" COMPONENT ehd)
install(SCRIPT cmake/install_made.cmake COMPONENT ehd)

install(TARGETS ehd_shared EXPORT ehd LIBRARY COMPONENT libehd0 NAMELINK_COMPONENT libehd-dev)
install(FILES bindings/c/ehd/ehd.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ehd COMPONENT libehd-dev)
install(FILES bindings/fortran/ehd.f90 bindings/fortran/example.f90
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ehd/fortran COMPONENT libehd-dev)

set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ehd)
install(EXPORT ehd NAMESPACE ehd:: FILE ehd-targets.cmake DESTINATION ${cmake_folder} COMPONENT libehd-dev)
file(CONFIGURE OUTPUT ehd-config.cmake CONTENT
  "include(\${CMAKE_CURRENT_LIST_DIR}/ehd-targets.cmake)\n" @ONLY)
write_basic_package_version_file(ehd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ehd-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/ehd-config-version.cmake
  DESTINATION ${cmake_folder} COMPONENT libehd-dev)

file(RELATIVE_PATH prefix_of_pc /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
file(CONFIGURE OUTPUT ehd.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@prefix_of_pc@
fortran=${prefix}/@CMAKE_INSTALL_DATADIR@/ehd/fortran

Name: ehd
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Cflags: -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ -lehd
]])
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ehd.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libehd-dev)
