// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace foundation
{

/// A record of a table of text: its cells, without blanks around them and without their quotes.
struct CsvRecord
{
    std::vector<std::string> cells; ///< one at least
    int lines = 1;                  ///< of the text: a quoted cell may have ends of lines in it
};

/// Takes the first record off a table whose cells are parted by `mark`. Between quotes marks and ends of
/// lines are part of the cell, and two quotes are one. Differs from the standard: blanks around a cell are
/// left out, also before a quote; a quote that is never closed ends with its line.
/// Source: RFC 4180, *Common format and MIME type for comma-separated values (CSV) files*, 2.
inline CsvRecord takeCsvRecord(std::string_view& text, char mark)
{
    const auto isBlank = [&](char c) { return (c == ' ' || c == '\t' || c == '\r') && c != mark; };
    CsvRecord record;
    std::size_t at = 0;
    // A return alone ends a line, as old programs write it; one before another end is a blank.
    const auto isEnd = [&](std::size_t i)
    {
        return text[i] == '\n' ||
               (text[i] == '\r' && i + 1 < text.size() && text[i + 1] != '\n' && text[i + 1] != '\r');
    };
    const auto skipBlanks = [&]
    {
        while (at < text.size() && isBlank(text[at]) && !isEnd(at))
            ++at;
    };
    const auto closingQuote = [&](std::size_t from)
    {
        std::size_t quote = text.find('"', from);
        while (quote != std::string_view::npos && quote + 1 < text.size() && text[quote + 1] == '"')
            quote = text.find('"', quote + 2);
        return quote;
    };
    for (bool isLast = false; !isLast;)
    {
        skipBlanks();
        std::string cell;
        const std::size_t end =
            at < text.size() && text[at] == '"' ? closingQuote(at + 1) : std::string_view::npos;
        if (end != std::string_view::npos)
        {
            for (std::size_t i = at + 1; i < end; ++i)
            {
                cell += text[i];
                if (text[i] == '"') ++i; // the second of two
            }
            record.lines += static_cast<int>(std::count(cell.begin(), cell.end(), '\n'));
            at = end + 1;
        }
        const std::size_t rest = at;
        while (at < text.size() && text[at] != mark && !isEnd(at))
            ++at;
        std::string_view unquoted = text.substr(rest, at - rest);
        while (!unquoted.empty() && isBlank(unquoted.back()))
            unquoted.remove_suffix(1);
        cell += unquoted;
        record.cells.push_back(std::move(cell));
        isLast = at >= text.size() || isEnd(at);
        if (at < text.size()) ++at;
    }
    text.remove_prefix(at);
    return record;
}

/// Whether a text must be quoted to be one cell of a table parted by commas.
inline bool needsCsvQuotes(std::string_view text)
{
    return text.find_first_of(",\"\r\n") != std::string_view::npos ||
           (!text.empty() && (text.front() == ' ' || text.back() == ' '));
}

/// Returns a text as a cell of such a table: as it is, or between quotes.
inline std::string csvCell(std::string_view text)
{
    if (!needsCsvQuotes(text)) return std::string(text);
    std::string cell = "\"";
    for (const char c : text)
        cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + '"';
}

} // namespace foundation
