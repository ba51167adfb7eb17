# SPDX-License-Identifier: Apache-2.0
# One way to declare each kind of target, so that include paths, warnings and names cannot drift apart.

# osgtrainer_library(NAME INCLUDE dir SOURCES … LINK … PRIVATE …): a static library, its alias osgTrainer::NAME, its
# install rules. NAME is a component of the package; a name that ends in _core installs the headers below core/ alone.
function(osgtrainer_library name)
    cmake_parse_arguments(arg "" "INCLUDE" "SOURCES;LINK;PRIVATE" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    add_library(osgTrainer::${name} ALIAS ${name})
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${arg_INCLUDE}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE $<BUILD_INTERFACE:osgTrainer_warnings> ${arg_PRIVATE})
    target_compile_features(${name} PUBLIC cxx_std_20)
    # The same rounding everywhere: a fused multiply-add would make pictures and meshes depend on the CPU.
    target_compile_options(${name} PRIVATE -ffp-contract=off)

    set_property(GLOBAL APPEND PROPERTY OSGTRAINER_COMPONENTS ${name})
    install(TARGETS ${name} EXPORT osgTrainerTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(name MATCHES "_core$")
        install(DIRECTORY ${arg_INCLUDE}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING REGEX "/core/.*\\.h$")
    else()
        install(DIRECTORY ${arg_INCLUDE}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
endfunction()

# osgtrainer_test(NAME LABEL core|osg|render SOURCES ... LINK ...): a GoogleTest program, discovered test by test.
function(osgtrainer_test name)
    cmake_parse_arguments(arg "" "LABEL;TIMEOUT" "SOURCES;LINK" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    if(OSGTRAINER_SANITIZE)
        math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 5")
    endif()
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
    target_link_libraries(${name} PRIVATE ${arg_LINK} osgTrainer_warnings GTest::gtest_main GTest::gmock)
    target_compile_options(${name} PRIVATE -ffp-contract=off)
    target_compile_definitions(${name} PRIVATE OSGTRAINER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    gtest_discover_tests(${name} TEST_PREFIX "${OSGTRAINER_TEST_PREFIX}" NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
        PROPERTIES LABELS ${arg_LABEL} TIMEOUT ${arg_TIMEOUT})
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
    target_link_libraries(${name} PRIVATE ${arg_LINK} osgTrainer_warnings)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/fuzz)
    if(NOT TARGET fuzzers)
        add_custom_target(fuzzers)
    endif()
    add_dependencies(fuzzers ${name})
endfunction()
