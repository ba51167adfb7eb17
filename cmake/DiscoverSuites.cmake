# SPDX-License-Identifier: Apache-2.0
# cmake -DPROGRAM=… -DOUTPUT=… -DPREFIX=… -DLABELS=label,label -DTIMEOUT=… -DSPLIT=suite,suite -P DiscoverSuites.cmake: writes OUTPUT,
# the ctest file of a GoogleTest program: one ctest test a suite, which runs in one process and makes its fixtures once;
# of a suite named in SPLIT one a test, so that a long suite spreads over the cores. Run after each link (TestTargets.cmake).
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE list RESULT_VARIABLE failed TIMEOUT 60)
if(failed)
    message(FATAL_ERROR "${PROGRAM} does not list its tests: ${failed}")
endif()
string(REPLACE "," ";" SPLIT "${SPLIT}")
string(REPLACE "," ";" LABELS "${LABELS}")

# A suite all of whose tests were skipped, and none failed.
set(all_skipped "\\\\[  PASSED  \\\\] 0 tests\\\\.\n\\\\[  SKIPPED \\\\] [0-9]+ tests?, listed below:\n(\\\\[  SKIPPED \\\\] [^\n]*\n)+$")
set(text "")
function(entry name filter)
    string(APPEND text "add_test([==[${PREFIX}${name}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${filter}]==])\n"
        "set_tests_properties([==[${PREFIX}${name}]==] PROPERTIES LABELS \"${LABELS}\" TIMEOUT ${TIMEOUT} "
        "SKIP_REGULAR_EXPRESSION \"${all_skipped}\")\n")
    set(text "${text}" PARENT_SCOPE)
endfunction()

# "Suite." at the start of a line, its tests indented below; a comment says what a parameter is.
string(REGEX REPLACE " *#[^\n]*" "" list "${list}")
string(REGEX MATCHALL "[^\n]+" lines "${list}")
set(split OFF)
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ].*)\\.$")
        set(suite ${CMAKE_MATCH_1})
        if(suite IN_LIST SPLIT)
            set(split ON)
            list(REMOVE_ITEM SPLIT ${suite})
        else()
            set(split OFF)
            entry(${suite} "${suite}.*")
        endif()
    elseif(split AND line MATCHES "^ +([^ ]+)$")
        entry("${suite}.${CMAKE_MATCH_1}" "${suite}.${CMAKE_MATCH_1}")
    endif()
endforeach()
if(SPLIT)
    message(FATAL_ERROR "${PROGRAM} has no suite ${SPLIT}, which SPLIT names")
endif()
if(text STREQUAL "")
    message(FATAL_ERROR "${PROGRAM} has no test")
endif()
file(WRITE ${OUTPUT} "${text}")
