// SPDX-License-Identifier: Apache-2.0
#include "input/LineReader.h"

#include <algorithm>

#include <foundation/LineCells.h>

#include "simulation/parser/Expression.h"

namespace trainer
{

namespace
{

std::string joined(const std::vector<std::string_view>& cells)
{
    std::string text;
    for (const std::string_view cell : cells)
        text += (text.empty() ? "" : " ") + std::string(cell);
    return text;
}

} // namespace

foundation::Outcome readLines(std::string_view text, const std::string& name, std::string_view first,
                              const std::function<foundation::Outcome(const TextLine&)>& take)
{
    const std::string remedy = "begin it with '" + std::string(first) + "'";
    bool isKnown = false;
    for (std::size_t number = 1; !text.empty(); ++number)
    {
        const std::size_t end = std::min(text.find('\n'), text.size());
        TextLine line{foundation::lineCells(text.substr(0, end)), name + ":" + std::to_string(number)};
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.cells.empty()) continue;
        if (isKnown)
        {
            if (const auto taken = take(line); !taken) return taken;
            continue;
        }
        if (joined(line.cells) != first) return foundation::Error{line.place, "is no such file", remedy};
        isKnown = true;
    }
    if (!isKnown) return foundation::Error{name, "is empty", remedy};
    return foundation::success();
}

std::optional<double> numberIn(std::string_view cell, double least, double most)
{
    const std::optional<double> number = simulation::parseNumber(cell);
    return number && *number >= least && *number <= most ? number : std::nullopt;
}

} // namespace trainer
