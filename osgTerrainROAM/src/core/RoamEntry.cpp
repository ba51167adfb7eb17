// SPDX-License-Identifier: Apache-2.0
#include "RoamEntry.h"

#include <charconv>
#include <cmath>
#include <system_error>

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

} // namespace osgTerrainROAM::core
