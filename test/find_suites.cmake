# Copyright (c) 2026 The CCSweep authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes one add_test() to OUTPUT for each outermost suite or case of the Boost.Test executable TESTS.
execute_process(COMMAND ${TESTS} --list_content=HRF
  OUTPUT_VARIABLE listed ERROR_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" lines "${listed}")
set(script)
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_]+)\\*")
    string(APPEND script "add_test([=[${CMAKE_MATCH_1}]=] [=[${TESTS}]=] --run_test=${CMAKE_MATCH_1})\n")
  endif()
endforeach()
if(NOT script)
  message(FATAL_ERROR "${TESTS} holds no test")
endif()
file(WRITE ${OUTPUT} "${script}")
