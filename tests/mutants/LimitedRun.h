// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// What a program may take.
struct RunLimits
{
    double seconds = 30.0;     ///< of processor time; four times as many elapse at most
    double memoryMiB = 2048.0; ///< resident, of the program or the largest of its children
};

/// What a program took, and how it ended.
struct LimitedRun
{
    int exitCode = -1; ///< 128 + signal when one ended it
    bool isOutOfTime = false;
    double seconds = 0.0; ///< of processor time
    double memoryMiB = 0.0;
    std::string errors; ///< its standard error, the first 4 kB

    /// Returns what is wrong with the run; empty when the program ended by itself within the limits, and an
    /// exit code above 0 came with a line of words.
    std::string fault(const RunLimits& limits) const;
};

/// Runs a command to its end, or kills it, with all its children, when it takes too long. A program that eats
/// memory is stopped at four times the limit of memory.
LimitedRun runLimited(const std::vector<std::string>& command, const RunLimits& limits);
