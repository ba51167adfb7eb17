# SPDX-License-Identifier: Apache-2.0
# Warnings are errors in this tree; a program that embeds the installed libraries keeps its own choice.
add_library(osgTrainer_warnings INTERFACE)
target_compile_options(osgTrainer_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wcast-qual -Wextra-semi -Wundef -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>) # false alarms of gcc 12 on std::string::operator+ (GCC bug 105651)
