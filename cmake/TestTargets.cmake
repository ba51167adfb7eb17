# SPDX-License-Identifier: Apache-2.0
# Programs that test: GoogleTest and libFuzzer.

# osgtrainer_test(NAME LABEL core|osg|render SOURCES ... LINK ... [TIMEOUT s] [SPLIT suite…] [OPTIMISED] [CHECKED]): a GoogleTest
# program, one ctest test a suite, or a test in the suites that SPLIT names: long ones whose tests share nothing. The short suites of
# label core run together (DiscoverSuites.cmake).
# ./check builds the target `checked` and runs the tests of that label: those of label core, and those that say CHECKED (decision 103).
# Most tests compute little in their own code, next to that of the libraries, and are compiled in little more than half the
# time without optimisation. OPTIMISED: this one computes so much that it would run for seconds longer.
# In a build of large units, tests that tests/JoinedTests.cmake joins are one program instead.
function(osgtrainer_test name)
    if(DEFINED OSGTRAINER_JOINED_IN_${name} AND CMAKE_UNITY_BUILD_BATCH_SIZE GREATER 32)
        osgtrainer_joined_member(${name} ${ARGN})
    else()
        osgtrainer_test_program(${name} ${ARGN})
    endif()
endfunction()

# osgtrainer_joined_tests(PROGRAM TEST…): declares a joined program, before the tests that it consists of.
macro(osgtrainer_joined_tests program)
    list(APPEND OSGTRAINER_JOINED_PROGRAMS ${program})
    foreach(test ${ARGN})
        set(OSGTRAINER_JOINED_IN_${test} ${program})
    endforeach()
endmacro()

# A member of a joined program: a target that is never built keeps what osgtrainer_test() and the commands behind it say.
function(osgtrainer_joined_member name)
    cmake_parse_arguments(arg "OPTIMISED" "LABEL;TIMEOUT" "SOURCES;LINK;SPLIT" ${ARGN})
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${arg_SOURCES})
    set_target_properties(${name} PROPERTIES EXPORT_COMPILE_COMMANDS OFF OSGTRAINER_KIND "${arg_LABEL};${arg_OPTIMISED}"
        OSGTRAINER_SPLIT "${arg_SPLIT}" OSGTRAINER_TIMEOUT "${arg_TIMEOUT}" LINK_LIBRARIES "${arg_LINK}")
    set_property(GLOBAL APPEND PROPERTY OSGTRAINER_MEMBERS_OF_${OSGTRAINER_JOINED_IN_${name}} ${name})
endfunction()

# osgtrainer_join_tests(): makes the joined programs of their members, after all tests are declared.
function(osgtrainer_join_tests)
    foreach(program IN LISTS OSGTRAINER_JOINED_PROGRAMS)
        get_property(members GLOBAL PROPERTY OSGTRAINER_MEMBERS_OF_${program})
        if(members)
            osgtrainer_joined_program(${program} ${members})
        endif()
    endforeach()
endfunction()

function(osgtrainer_joined_program program)
    foreach(list SOURCES LINK_LIBRARIES INCLUDE_DIRECTORIES COMPILE_DEFINITIONS MANUALLY_ADDED_DEPENDENCIES OSGTRAINER_SPLIT OSGTRAINER_TIMEOUT)
        set(${list})
        foreach(member IN LISTS ARGN)
            get_target_property(values ${member} ${list})
            if(values)
                list(APPEND ${list} ${values})
            endif()
            if("${list}" STREQUAL "SOURCES")
                get_target_property(folder ${member} SOURCE_DIR)
                list(TRANSFORM SOURCES PREPEND ${folder}/ REGEX "^[^/]")
            endif()
        endforeach()
        list(REMOVE_DUPLICATES ${list})
    endforeach()
    list(GET ARGN 0 first)
    get_target_property(kind ${first} OSGTRAINER_KIND)
    foreach(member IN LISTS ARGN)
        get_target_property(other ${member} OSGTRAINER_KIND)
        if(NOT "${other}" STREQUAL "${kind}")
            message(FATAL_ERROR "tests/JoinedTests.cmake: ${member} is ${other}, and ${first} in the same program is ${kind}")
        endif()
    endforeach()
    list(GET kind 0 label)
    list(GET kind 1 isOptimised)
    set(optimised)
    if(isOptimised)
        set(optimised OPTIMISED)
    endif()
    list(SORT OSGTRAINER_TIMEOUT COMPARE NATURAL ORDER DESCENDING)
    list(APPEND OSGTRAINER_TIMEOUT 600)
    list(GET OSGTRAINER_TIMEOUT 0 timeout)
    osgtrainer_test_program(${program} LABEL ${label} TIMEOUT ${timeout} ${optimised}
        SOURCES ${SOURCES} LINK ${LINK_LIBRARIES} SPLIT ${OSGTRAINER_SPLIT})
    target_include_directories(${program} PRIVATE ${INCLUDE_DIRECTORIES})
    target_compile_definitions(${program} PRIVATE ${COMPILE_DEFINITIONS})
    if(MANUALLY_ADDED_DEPENDENCIES)
        add_dependencies(${program} ${MANUALLY_ADDED_DEPENDENCIES})
    endif()
endfunction()

function(osgtrainer_test_program name)
    cmake_parse_arguments(arg "OPTIMISED;CHECKED" "LABEL;TIMEOUT" "SOURCES;LINK;SPLIT" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 600)
    endif()
    if(OSGTRAINER_SANITIZE)
        math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 5")
    endif()
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
    target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest_main GTest::gmock)
    target_compile_definitions(${name} PRIVATE OSGTRAINER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    osgtrainer_common(${name})
    # Tests of one program have small helpers of one name.
    if(CMAKE_UNITY_BUILD_BATCH_SIZE GREATER 32)
        osgtrainer_even_units(${name} 32)
    endif()
    if(NOT arg_OPTIMISED)
        target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0>)
    endif()
    target_compile_options(${name} PRIVATE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>) # false alarm: a unity file includes only sources
    set(labels ${arg_LABEL})
    # Starting the process of a core's test takes longer than what most suites do.
    set(long)
    if(arg_LABEL STREQUAL "core")
        set(long ${PROJECT_SOURCE_DIR}/tests/long.txt)
        set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${long})
    endif()
    if(arg_CHECKED OR arg_LABEL STREQUAL "core")
        string(APPEND labels ",checked")
        add_dependencies(checked ${name})
    endif()
    set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
    list(JOIN arg_SPLIT "," split)
    add_custom_command(TARGET ${name} POST_BUILD VERBATIM
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}> -DOUTPUT=${suites} -DPREFIX=${OSGTRAINER_TEST_PREFIX}
            -DLABELS=${labels} -DTIMEOUT=${arg_TIMEOUT} -DSPLIT=${split} -DLONG=${long}
            -P ${PROJECT_SOURCE_DIR}/cmake/DiscoverSuites.cmake)
    set(included ${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake)
    file(WRITE ${included} "if(EXISTS [==[${suites}]==])\n    include([==[${suites}]==])\nelse()\n"
        "    add_test(${OSGTRAINER_TEST_PREFIX}${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${included})
endfunction()

# osgtrainer_runs(NAME WHAT…): a test runs programs, loads plugins or opens made files, which are built with it; not where the compiler
# makes no code (OSGTRAINER_SYNTAX_ONLY), hence nothing that could be run.
function(osgtrainer_runs name)
    if(NOT OSGTRAINER_SYNTAX_ONLY)
        add_dependencies(${name} ${ARGN})
    endif()
endfunction()

# osgtrainer_fuzzer(NAME SOURCES … LINK …): a libFuzzer program of the tree configured with OSGTRAINER_FUZZ=ON,
# bin/fuzz/NAME, built by the target `fuzzers` and run by scripts/fuzz from the seeds in tests/fuzz/corpus.
function(osgtrainer_fuzzer name)
    if(NOT OSGTRAINER_FUZZ)
        return()
    endif()
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
    target_compile_definitions(${name} PRIVATE OSGTRAINER_LIBFUZZER)
    target_link_libraries(${name} PRIVATE ${arg_LINK})
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/fuzz)
    osgtrainer_common(${name})
    if(NOT TARGET fuzzers)
        add_custom_target(fuzzers)
    endif()
    add_dependencies(fuzzers ${name})
endfunction()
