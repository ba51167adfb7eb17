// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace trainer
{

/// The arguments of `trainer check`.
struct CheckRequest
{
    std::vector<std::filesystem::path> scenarios;
    bool isStrict = false;          ///< what is not in effect counts as wrong
    std::filesystem::path jsonFile; ///< empty: none
    bool printsCoverage = false;    ///< instead of checking: the table of elements
};

/// Prints every problem of the scenarios, one a line, and returns the exit code: kDone when nothing is wrong,
/// kFailed otherwise, kWrongUse without a file. What is not in effect is printed, and is not wrong.
int check(const CheckRequest& request);

} // namespace trainer
