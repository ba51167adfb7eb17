// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace osgRoads::core
{

/// Returns a number with six digits at most, for messages.
inline std::string shortNumber(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

enum class ProblemKind
{
    unsupported, ///< sound, but not understood: passed over
    mistake,     ///< breaks the standard: repaired as told, or passed over
};

/// Something in a file that is not used as its author meant it.
struct Problem
{
    ProblemKind kind = ProblemKind::mistake;
    int line = 0;          ///< of the first occurrence
    std::size_t count = 1; ///< occurrences
    std::string what, remedy;

    /// One line: "file:line: what; remedy", with the count when there are several.
    std::string message(const std::string& file) const
    {
        return file + ":" + std::to_string(line) + ": " + what +
               (count > 1 ? " (" + std::to_string(count) + " times)" : "") +
               (remedy.empty() ? "" : "; " + remedy);
    }
};

/// Returns the first ten problems of a file as lines, and one for the number of the others.
inline std::vector<std::string> firstMessages(const std::vector<Problem>& problems, const std::string& file)
{
    constexpr std::size_t kMost = 10;
    std::vector<std::string> messages;
    for (const Problem& problem : problems)
        if (messages.size() < kMost) messages.push_back(problem.message(file));
    if (problems.size() > kMost)
        messages.push_back(file + ": " + std::to_string(problems.size() - kMost) +
                           " more; roadtool validate tells them all");
    return messages;
}

} // namespace osgRoads::core
