// SPDX-License-Identifier: Apache-2.0
#include "terminal/MovedCommand.h"

#include <algorithm>

#include "terminal/Terminal.h"

namespace terminal
{

std::optional<int> answerMoved(const std::string& program, std::span<const MovedCommand> moved, int argc,
                               const char* const* argv)
{
    if (argc < 2) return std::nullopt;
    const auto found = std::ranges::find(moved, std::string_view(argv[1]), &MovedCommand::name);
    if (found == moved.end()) return std::nullopt;
    fail(program, {std::string(found->name), "is a command of another program now",
                   "call " + std::string(found->place)});
    return kWrongUse;
}

} // namespace terminal
