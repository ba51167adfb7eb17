// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace terminal
{

/// A command that another program has now.
struct MovedCommand
{
    std::string_view name;  ///< as it was
    std::string_view place; ///< the program, and its command, that do it now
};

/// Looks whether the command line begins with one of `moved`. Returns kWrongUse, after one line on stderr
/// that says where it went; nothing for any other command line. To be called before the command line is
/// parsed.
std::optional<int> answerMoved(const std::string& program, std::span<const MovedCommand> moved, int argc,
                               const char* const* argv);

} // namespace terminal
