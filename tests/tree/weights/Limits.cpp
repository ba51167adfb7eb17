// SPDX-License-Identifier: Apache-2.0
#include "Limits.h"

#include <fstream>
#include <regex>

namespace
{

constexpr std::string_view kHeader = "header ";

} // namespace

foundation::Result<Limits> readLimits(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    if (!stream)
        return foundation::Error{file.string(), "the limits cannot be read",
                                 "bring the file back (git log -- tests/tree/weights.txt)"};
    static const std::regex form(R"(((?:demo|check|all) (?:units|lines)|header \S+)\s+(\d{1,12}))");
    Limits limits;
    int number = 0;
    for (std::string line; std::getline(stream, line);)
    {
        ++number;
        line = line.substr(0, line.find('#'));
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.empty()) continue;
        const std::string place = file.string() + ":" + std::to_string(number);
        std::smatch parts;
        if (!std::regex_match(line, parts, form))
            return foundation::Error{place, "not a limit: '" + line + "'",
                                     "write e.g. 'header simulation/ 70000'"};
        if (!limits.emplace(parts[1], std::stol(parts[2])).second)
            return foundation::Error{place, "the limit '" + parts[1].str() + "' stands twice", "keep one"};
    }
    return limits;
}

std::string headerLimit(const Limits& limits, const std::string& header)
{
    std::string longest;
    for (const auto& [name, limit] : limits)
        if (name.starts_with(kHeader) && header.starts_with(name.substr(kHeader.size())) &&
            name.size() > longest.size())
            longest = name;
    return longest;
}

std::vector<std::string> raised(const Limits& before, const Limits& after)
{
    std::vector<std::string> lines;
    for (const auto& [name, limit] : before)
        if (!after.contains(name)) lines.push_back(name + ": the limit is gone");
    for (const auto& [name, limit] : after)
    {
        const std::string bound =
            before.contains(name) ? name : headerLimit(before, name.substr(kHeader.size()));
        if (const auto old = before.find(bound); old != before.end() && limit > old->second)
            lines.push_back(name + ": from " + std::to_string(old->second) + " to " + std::to_string(limit));
    }
    return lines;
}
