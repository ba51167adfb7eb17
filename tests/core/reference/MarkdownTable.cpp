// SPDX-License-Identifier: Apache-2.0
#include "MarkdownTable.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace reference
{

namespace
{

/// A heading's text, or nothing.
std::string headingOf(const std::string& line)
{
    const std::size_t hashes = line.find_first_not_of('#');
    if (hashes == 0 || hashes == std::string::npos || line[hashes] != ' ') return {};
    std::string text = line.substr(hashes + 1);
    std::erase(text, '`');
    return text;
}

std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');)
        cells.push_back(cell);
    return cells;
}

} // namespace

std::string sourceText(const std::filesystem::path& relative)
{
    std::ifstream stream(std::filesystem::path(OSGTRAINER_SOURCE_DIR) / relative);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string sourceTexts(const std::filesystem::path& folder, const std::string& exceptStem)
{
    std::string text;
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(OSGTRAINER_SOURCE_DIR) / folder))
        if (file.path().extension() == ".cpp" && file.path().stem() != exceptStem)
            text += sourceText(folder / file.path().filename());
    return text;
}

Names quotedIn(std::string_view text)
{
    Names names;
    for (std::size_t at = text.find('`'); at != std::string_view::npos; at = text.find('`', at))
    {
        const std::size_t end = text.find('`', at + 1);
        if (end == std::string_view::npos) break;
        names.emplace(text.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return names;
}

std::vector<std::vector<std::string>> Page::rows(std::string_view heading) const
{
    std::vector<std::vector<std::string>> found;
    std::istringstream stream(_text);
    bool isWithin = false;
    for (std::string line; std::getline(stream, line);)
    {
        if (line.starts_with('#')) isWithin = headingOf(line) == heading;
        if (isWithin && line.starts_with("| `")) found.push_back(cellsOf(line));
    }
    return found;
}

Names Page::column(std::string_view heading, std::size_t column) const
{
    Names names;
    for (const auto& cells : rows(heading))
        if (column < cells.size()) names.merge(quotedIn(cells[column]));
    return names;
}

Names Page::wordsBeside(std::string_view heading, const std::string& name) const
{
    Names words;
    for (const auto& cells : rows(heading))
        if (quotedIn(cells.front()).contains(name))
            for (std::size_t i = 1; i < cells.size(); ++i)
                words.merge(quotedIn(cells[i]));
    return words;
}

Names Page::headings(std::string_view beginning) const
{
    Names found;
    std::istringstream stream(_text);
    for (std::string line; std::getline(stream, line);)
        if (const std::string heading = headingOf(line); !heading.empty() && heading.starts_with(beginning))
            found.insert(heading);
    return found;
}

Page Page::without(const std::string& name) const
{
    std::istringstream stream(_text);
    std::string kept;
    for (std::string line; std::getline(stream, line);)
        if (!line.starts_with("| `" + name + "` |")) kept += line + '\n';
    return Page(kept);
}

Page Page::with(std::string_view heading, const std::string& name) const
{
    std::istringstream stream(_text);
    std::string more;
    for (std::string line; std::getline(stream, line);)
    {
        more += line + '\n';
        if (line.starts_with('#') && headingOf(line) == heading) more += "| `" + name + "` | | |\n";
    }
    return Page(more);
}

std::string differences(const Names& code, const Names& page)
{
    if (code.empty()) return "the code has no names at all\n";
    std::string text;
    for (const std::string& name : code)
        if (!page.contains(name)) text += "not described: " + name + '\n';
    for (const std::string& name : page)
        if (!code.contains(name)) text += "described, but the code has no such name: " + name + '\n';
    return text;
}

} // namespace reference
