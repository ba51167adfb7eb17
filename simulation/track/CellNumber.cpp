// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/CellNumber.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "simulation/parser/Expression.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

/// Whether a text is groups of three digits between marks, as 1,640.
bool isGrouped(std::string_view text, char mark)
{
    const std::size_t first = text.find(mark);
    if (first == std::string_view::npos || first == 0 || first > 3) return false;
    for (std::size_t at = first; at < text.size(); at += 4)
        if (text[at] != mark || at + 4 > text.size() ||
            !std::all_of(text.begin() + static_cast<long>(at) + 1, text.begin() + static_cast<long>(at) + 4,
                         [](unsigned char c) { return std::isdigit(c); }))
            return false;
    return true;
}

} // namespace

std::optional<CellNumber> cellNumber(std::string_view cell, bool isDecimalComma)
{
    const auto isPart = [](unsigned char c)
    { return std::isdigit(c) || c == '+' || c == '-' || c == '.' || c == ','; };
    cell = trimmed(cell);
    const auto begin = std::find_if(cell.begin(), cell.end(), isPart);
    auto end = begin;
    while (end != cell.end() && (isPart(static_cast<unsigned char>(*end)) ||
                                 ((*end == 'e' || *end == 'E') && std::next(end) != cell.end() &&
                                  isPart(static_cast<unsigned char>(*std::next(end))))))
        ++end;
    CellNumber number;
    const auto capitals = [](std::string_view text)
    {
        std::string result;
        for (const char c : trimmed(text))
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return result;
    };
    number.before = capitals({cell.begin(), begin});
    number.behind = capitals({end, cell.end()});
    std::string text(begin, end);
    const std::size_t comma = text.rfind(','), point = text.rfind('.');
    const bool hasBoth = comma != std::string::npos && point != std::string::npos;
    char decimal = hasBoth ? (comma > point ? ',' : '.') : comma != std::string::npos ? ',' : '.';
    const std::size_t sign = text.find_first_of("+-") == 0 ? 1 : 0;
    if (!hasBoth && isGrouped(std::string_view(text).substr(sign), decimal) &&
        isDecimalComma != (decimal == ','))
        decimal = decimal == ',' ? '.' : ','; // its only marks part groups
    std::erase(text, decimal == ',' ? '.' : ',');
    std::replace(text.begin(), text.end(), ',', '.');
    const auto value = parseNumber(text);
    if (!value) return std::nullopt;
    number.value = *value;
    return number;
}

} // namespace simulation
