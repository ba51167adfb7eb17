// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// An include line names a file: in quotes or in angle brackets, or as what stands after the including folder
/// (#include_next).
struct IncludeLine
{
    std::string name;
    bool quoted = false;
    bool next = false;
};

/// What a C++ file weighs by itself: the lines that a preprocessor passes on, and the files that it includes.
struct SourceText
{
    long lines = 0;
    std::vector<IncludeLine> includes;
};

/// Counts the lines with code, which are neither empty nor comments nor directives, and lists the include
/// lines. Conditions are not evaluated: a file under #ifdef counts, too.
SourceText readSourceText(std::string_view text);
