// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

/// Declares `name` as a file or folder of the real data, `relative` to the folder that the environment
/// variable OSGTRAINER_REAL_DATA names. Without the variable the test is skipped and says so; with it, a
/// missing file fails.
// NOLINTBEGIN(bugprone-macro-parentheses): a declared name cannot stand in parentheses
#define OSGTRAINER_REAL_DATA_OR_SKIP(name, relative)                                                         \
    const char* const name##Base = std::getenv("OSGTRAINER_REAL_DATA");                                      \
    if (!name##Base || !*name##Base)                                                                         \
        GTEST_SKIP() << "NOT TESTED ON REAL DATA: set OSGTRAINER_REAL_DATA to their folder";                 \
    const std::filesystem::path name = std::filesystem::path(name##Base) / (relative);                       \
    ASSERT_TRUE(std::filesystem::exists(name)) << name << " is missing from the real data"
// NOLINTEND(bugprone-macro-parentheses)

namespace testsupport
{

/// Names a test of a file, its parameter, after it.
struct AfterFile
{
    template<class Parameter>
    std::string operator()(const testing::TestParamInfo<Parameter>& info) const
    {
        std::string name = info.param;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    }
};

} // namespace testsupport
