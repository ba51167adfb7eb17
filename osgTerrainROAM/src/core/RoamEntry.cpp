// SPDX-License-Identifier: Apache-2.0
#include "RoamEntry.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

#include "TextLines.h"

namespace osgTerrainROAM::core
{

foundation::Result<std::vector<double>> numbers(const RoamEntry& entry, std::size_t least, std::size_t most)
{
    std::vector<double> found;
    const char* at = entry.value.data();
    const char* const end = at + entry.value.size();
    while (at != end)
    {
        if (*at == ' ' || *at == '\t')
        {
            ++at;
            continue;
        }
        double number = 0.0;
        const auto [next, failure] = std::from_chars(at, end, number);
        const bool ends = next == end || *next == ' ' || *next == '\t';
        if (failure != std::errc() || !ends || !std::isfinite(number))
            return entry.error("'" + std::string(entry.value) + "' is not a number that " +
                                   std::string(entry.key) + " can have",
                               "write plain decimal numbers");
        found.push_back(number);
        at = next;
    }
    if (found.size() < least || found.size() > most)
        return entry.error(std::string(entry.key) + " has " + std::to_string(found.size()) + " numbers",
                           "give " + std::to_string(least) +
                               (most > least ? " to " + std::to_string(most) : std::string()));
    return found;
}

foundation::Result<double> numberWithin(const RoamEntry& entry, double low, double high)
{
    const auto found = numbers(entry, 1, 1);
    if (!found) return found.error();
    const double number = found->front();
    if (number < low || number > high)
        return entry.error(std::string(entry.key) + " = " + std::string(entry.value) + " is out of range",
                           "give a number from " + std::to_string(low) + " to " + std::to_string(high));
    return number;
}

foundation::Outcome assignPath(std::filesystem::path& target, const RoamEntry& entry)
{
    const std::filesystem::path path{std::string(entry.value)};
    target = path.is_absolute() ? path : entry.folder / path;
    return foundation::success();
}

foundation::Error unknownWord(const RoamEntry& entry, const std::string& choices)
{
    return entry.error(std::string(entry.key) + " = '" + std::string(entry.value) + "' is unknown",
                       "use one of: " + choices);
}

foundation::Outcome visitEntries(std::string_view text, const std::filesystem::path& name,
                                 const std::string& keys,
                                 const std::function<foundation::Outcome(const RoamEntry&)>& visit)
{
    std::size_t line = 0;
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view content = text.substr(at, end - at);
        at = end + 1;
        ++line;
        content = trimmed(content.substr(0, content.find('#')));
        if (content.empty()) continue;
        RoamEntry entry{name.string() + ":" + std::to_string(line), {}, {}, name.parent_path()};
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos || content.find('\0') != std::string_view::npos)
            return entry.error("not of the form key = value", "see the keys: " + keys);
        entry.key = trimmed(content.substr(0, equals));
        entry.value = trimmed(content.substr(equals + 1));
        if (const auto visited = visit(entry); !visited) return visited.error();
    }
    return foundation::success();
}

foundation::Result<std::string> readEntries(const std::filesystem::path& file)
{
    constexpr std::size_t kMostBytes = 1 << 20; // a larger file is not such a text
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return foundation::Error{file.string(), "cannot be read", "check the path and its permissions"};
    std::string text(kMostBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    const std::string kind = file.extension().string();
    if (text.size() > kMostBytes || text.find('\0') != std::string::npos)
        return foundation::Error{file.string(), "is no " + kind + " text",
                                 "a " + kind + " file holds lines key = value"};
    return text;
}

} // namespace osgTerrainROAM::core
