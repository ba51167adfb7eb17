// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace foundation
{

/// An error says why a piece of data could not be used: where it is, what is wrong with it, what its owner
/// can do.
struct Error
{
    std::string place;  ///< file, or file:line, or option
    std::string what;   ///< what was found
    std::string remedy; ///< what to do about it

    /// One line: "place: what; remedy".
    std::string message() const { return place + ": " + what + (remedy.empty() ? "" : "; " + remedy); }
};

} // namespace foundation
