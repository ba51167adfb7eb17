// SPDX-License-Identifier: Apache-2.0
#include "input/DeviceFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <foundation/Excerpt.h>
#include <foundation/NearestWord.h>
#include <foundation/SmallLetters.h>
#include <foundation/WholeText.h>

#include "input/Keys.h"
#include "input/LineReader.h"
#include "simulation/vehicle/flight/FlightInputs.h"
#include "simulation/vehicle/road/RoadInputs.h"

namespace trainer
{

namespace
{

constexpr std::uintmax_t kMostDeviceBytes = 1U << 20;
constexpr std::size_t kMostParts = 10'000;
constexpr double kMostAxis = 63.0, kMostButton = 255.0;

/// The inputs of all vehicles, and both brakes together. Those of JSBSim have a '/' in them.
std::vector<std::string_view> inputNames()
{
    std::vector<std::string_view> names{"brakes"};
    names.insert(names.end(), simulation::kFlightInputNames.begin(), simulation::kFlightInputNames.end());
    names.insert(names.end(), simulation::kRoadInputNames.begin(), simulation::kRoadInputNames.end());
    return names;
}

bool isInput(std::string_view name)
{
    const auto names = inputNames();
    return name.find('/') != name.npos || std::find(names.begin(), names.end(), name) != names.end();
}

class DeviceReader
{
public:
    foundation::Outcome take(const TextLine& line)
    {
        const std::string_view word = line.cells[0];
        if (++_parts > kMostParts) return wrong(line, "more than 10000 lines", "shorten it");
        if (word == "device") return takeDevice(line);
        if (word != "axis" && word != "button")
            return wrong(line, "'" + foundation::excerpt(word) + "' is no word of a devices file",
                         "write device, axis or button");
        if (maps.empty())
            return wrong(line, "'" + std::string(word) + "' before any device", "write 'device *' first");
        return word == "axis" ? takeAxis(line) : takeButton(line);
    }

    std::vector<DeviceMap> maps;

private:
    static foundation::Error wrong(const TextLine& line, const std::string& what, const std::string& remedy)
    {
        return {line.place, what, remedy};
    }

    foundation::Outcome takeDevice(const TextLine& line)
    {
        std::string name;
        for (std::size_t i = 1; i < line.cells.size(); ++i)
            name += (i > 1 ? " " : "") + std::string(line.cells[i]);
        if (name.empty()) return wrong(line, "a device without a name", "write part of it, or *");
        maps.push_back({std::move(name), {}, {}});
        return foundation::success();
    }

    foundation::Outcome takeAxis(const TextLine& line)
    {
        const auto& cells = line.cells;
        const auto number = cells.size() > 2 ? numberIn(cells[1], 0.0, kMostAxis) : std::nullopt;
        if (!number || *number != std::floor(*number))
            return wrong(line, "no axis", "write axis NUMBER INPUT, counted from 0 to 63");
        DeviceAxis axis{static_cast<int>(*number), std::string(cells[2])};
        for (std::size_t i = 3; i < cells.size(); ++i)
        {
            const auto value = [&](double least, double most)
            { return i + 1 < cells.size() ? numberIn(cells[i + 1], least, most) : std::nullopt; };
            if (cells[i] == "inverted")
            {
                axis.isInverted = true;
                continue;
            }
            if (const auto dead = value(0.0, 0.9); cells[i] == "dead" && dead)
                axis.dead = *dead;
            else if (const auto curve = value(0.1, 10.0); cells[i] == "curve" && curve)
                axis.curve = *curve;
            else
                return wrong(line, "'" + foundation::excerpt(cells[i]) + "' is wrong here",
                             "write inverted, dead 0 to 0.9 or curve 0.1 to 10");
            ++i;
        }
        if (!isInput(cells[2]))
            return wrong(
                line, "there is no input '" + foundation::excerpt(cells[2]) + "'",
                foundation::didYouMean(cells[2], inputNames(), "docs/reference/inputs-file.md lists all"));
        maps.back().axes.push_back(std::move(axis));
        return foundation::success();
    }

    foundation::Outcome takeButton(const TextLine& line)
    {
        const auto& cells = line.cells;
        const auto number = cells.size() == 3 ? numberIn(cells[1], 0.0, kMostButton) : std::nullopt;
        if (!number || *number != std::floor(*number))
            return wrong(line, "no button", "write button NUMBER KEY, counted from 0 to 255");
        const auto key = keyOf(cells[2]);
        if (!key)
            return wrong(line, "there is no key '" + foundation::excerpt(cells[2]) + "'",
                         "write one of docs/reference/keys.md");
        maps.back().buttons.push_back({static_cast<int>(*number), *key});
        return foundation::success();
    }

    std::size_t _parts = 0;
};

} // namespace

double inputOf(const DeviceAxis& axis, double place, double least, double most)
{
    if (!std::isfinite(place)) place = 0.0;
    place = std::clamp(axis.isInverted ? -place : place, -1.0, 1.0);
    const bool isBothWays = least < 0.0;
    double share = isBothWays ? std::abs(place) : 0.5 * (place + 1.0); // of the way from the rest
    share = std::max(0.0, share - axis.dead) / (1.0 - axis.dead);
    share = std::pow(share, axis.curve);
    if (!isBothWays) return least + share * (most - least);
    return place < 0.0 ? share * least : share * most;
}

const DeviceMap* mapFor(const std::vector<DeviceMap>& maps, std::string_view name)
{
    const std::string known = foundation::inSmallLetters(name);
    for (const DeviceMap& map : maps)
        if (map.name == "*" || known.find(foundation::inSmallLetters(map.name)) != std::string::npos)
            return &map;
    return nullptr;
}

foundation::Result<std::vector<DeviceMap>> parseDevices(std::string_view text, const std::string& name)
{
    DeviceReader reader;
    if (const auto read = readLines(text, name, "osgtrainer-devices 1",
                                    [&](const TextLine& line) { return reader.take(line); });
        !read)
        return read.error();
    return std::move(reader.maps);
}

foundation::Result<std::vector<DeviceMap>> readDevices(const std::filesystem::path& file)
{
    const auto text = foundation::readWholeText(file, kMostDeviceBytes);
    if (!text) return text.error();
    return parseDevices(*text, file.string());
}

} // namespace trainer
