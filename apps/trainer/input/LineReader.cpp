// SPDX-License-Identifier: Apache-2.0
#include "input/LineReader.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <foundation/ReadableFile.h>

#include "simulation/parser/Expression.h"

namespace trainer
{

namespace
{

std::vector<std::string_view> cellsOf(std::string_view line)
{
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> cells;
    for (std::size_t at = 0;;)
    {
        at = line.find_first_not_of(" \t\r", at);
        if (at == std::string_view::npos) return cells;
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = end;
    }
}

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
        TextLine line{cellsOf(text.substr(0, end)), name + ":" + std::to_string(number)};
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

foundation::Result<std::string> wholeText(const std::filesystem::path& file, std::uintmax_t mostBytes)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    std::error_code code;
    if (std::filesystem::file_size(file, code) > mostBytes || code)
        return foundation::Error{file.string(), "is larger than " + std::to_string(mostBytes >> 20) + " MiB",
                                 "shorten it"};
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace trainer
