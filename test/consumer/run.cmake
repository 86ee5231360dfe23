# Copyright (c) 2026 The CCSweep authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Builds the project beside this file against the installed package (WAY=find_package), and runs it; or configures
# it with the sources as a subdirectory (WAY=add_subdirectory), where nothing but the library may come along.
set(source ${CMAKE_CURRENT_LIST_DIR})
set(configure ${CMAKE_COMMAND} -S ${source} -B ${SCRATCH}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release)
file(REMOVE_RECURSE ${SCRATCH})

if(WAY STREQUAL add_subdirectory)
  execute_process(COMMAND ${configure} -D CCSWEEP_SOURCE_DIR=${SOURCE_DIR} COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB extras ${SCRATCH}/build/ccsweep/examples ${SCRATCH}/build/ccsweep/test ${SCRATCH}/build/ccsweep/doc)
  if(extras)
    message(FATAL_ERROR "As a subdirectory the library brought along ${extras}")
  endif()
  return()
endif()

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${SCRATCH}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${configure} -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SCRATCH}/build/consumer ${SOURCE_DIR}/test/data/cylinder.ply
  OUTPUT_VARIABLE volumes OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT volumes STREQUAL "2")
  message(FATAL_ERROR "The consumer found '${volumes}' sub-volumes in the cylinder, not 2")
endif()
