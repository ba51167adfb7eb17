# SPDX-License-Identifier: Apache-2.0
# Programs that test: GoogleTest and libFuzzer.

# osgtrainer_test(NAME LABEL core|osg|render SOURCES ... LINK ... [TIMEOUT s] [SPLIT suite…] [OPTIMISED]): a GoogleTest
# program, one ctest test a suite, or a test in the suites that SPLIT names: long ones whose tests share nothing.
# Most tests compute little in their own code, next to that of the libraries, and are compiled in little more than half the
# time without optimisation. OPTIMISED: this one computes so much that it would run for seconds longer.
function(osgtrainer_test name)
    cmake_parse_arguments(arg "OPTIMISED" "LABEL;TIMEOUT" "SOURCES;LINK;SPLIT" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 600)
    endif()
    if(OSGTRAINER_SANITIZE)
        math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 5")
    endif()
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
    target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest_main GTest::gmock)
    # Tests of one program have small helpers of one name.
    if(CMAKE_UNITY_BUILD_BATCH_SIZE GREATER 32)
        set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 32)
    endif()
    target_compile_definitions(${name} PRIVATE OSGTRAINER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    osgtrainer_common(${name})
    if(NOT arg_OPTIMISED)
        target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0>)
    endif()
    target_compile_options(${name} PRIVATE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>) # false alarm: a unity file includes only sources
    set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
    list(JOIN arg_SPLIT "," split)
    add_custom_command(TARGET ${name} POST_BUILD VERBATIM
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}> -DOUTPUT=${suites} -DPREFIX=${OSGTRAINER_TEST_PREFIX}
            -DLABEL=${arg_LABEL} -DTIMEOUT=${arg_TIMEOUT} -DSPLIT=${split} -P ${PROJECT_SOURCE_DIR}/cmake/DiscoverSuites.cmake)
    set(included ${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake)
    file(WRITE ${included} "if(EXISTS [==[${suites}]==])\n    include([==[${suites}]==])\nelse()\n"
        "    add_test(${OSGTRAINER_TEST_PREFIX}${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${included})
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
    target_link_libraries(${name} PRIVATE ${arg_LINK})
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/fuzz)
    osgtrainer_common(${name})
    if(NOT TARGET fuzzers)
        add_custom_target(fuzzers)
    endif()
    add_dependencies(fuzzers ${name})
endfunction()
