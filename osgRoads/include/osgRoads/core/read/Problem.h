// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

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

} // namespace osgRoads::core
