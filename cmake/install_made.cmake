# SPDX-License-Identifier: GPL-3.0-or-later
# Run by `cmake --install`: files that the program itself writes. EHD_PROGRAM: the program that was built; EHD_SHARE:
# the folder share under the prefix.
set(share $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${EHD_SHARE})

function(ehd_install_completion shell file)
  execute_process(COMMAND ${EHD_PROGRAM} --completion ${shell} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${share}/${file} "${text}")
  message(STATUS "Installing: ${share}/${file}")
endfunction()
ehd_install_completion(bash bash-completion/completions/ehd)
ehd_install_completion(zsh zsh/vendor-completions/_ehd)

find_program(EHD_HELP2MAN help2man)
if(EHD_HELP2MAN)
  execute_process(COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/man.sh ${EHD_PROGRAM} ${share}/man/man1
    COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${share}/man/man1")
else()
  message(STATUS "No manual pages: help2man is not installed")
endif()
