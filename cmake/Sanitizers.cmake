# SPDX-License-Identifier: Apache-2.0
# OSGTRAINER_SANITIZE names the sanitizers; a report ends the test that made it, with the lines that the presets' -g1 keeps.
# What is suppressed, and why, stands in SanitizerSuppressions.cpp, which every program carries: Mesa, OSG and GDAL, which
# are not built with them.
if(OSGTRAINER_SANITIZE)
    string(REPLACE ";" "," sanitizers "${OSGTRAINER_SANITIZE}")
    add_compile_options(-fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${sanitizers})
    # With sanitizers gcc 12 takes members of std::variant, std::function and std::optional for used before they are set.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# Fuzzing needs its coverage counters in the libraries too, not only in the program that drives them.
if(OSGTRAINER_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "OSGTRAINER_FUZZ needs clang: configure with the preset `fuzz`")
    endif()
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

if(OSGTRAINER_SANITIZE OR OSGTRAINER_FUZZ)
    add_library(sanitizer_suppressions OBJECT ${CMAKE_CURRENT_LIST_DIR}/SanitizerSuppressions.cpp)
    link_libraries($<TARGET_OBJECTS:sanitizer_suppressions>)
endif()
