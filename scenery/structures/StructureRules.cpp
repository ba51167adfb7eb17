// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <foundation/TagQuantity.h>

#include "scenery/structures/Structure.h"

namespace scenery
{

namespace
{

std::string_view tagOf(const StructureTags& tags, std::string_view key)
{
    const auto found = tags.find(key);
    return found == tags.end() ? std::string_view() : std::string_view(found->second);
}

bool isTagged(const StructureTags& tags, std::string_view key)
{
    const auto value = tagOf(tags, key);
    return !value.empty() && value != "no";
}

double metresOf(const StructureTags& tags, std::string_view key, double least, double most, double otherwise)
{
    const auto number = foundation::metresOfTag(tagOf(tags, key));
    return number && *number >= least && *number <= most ? *number : otherwise;
}

/// The numbers of a list "1.5;2.25;…"; none where one is no number.
std::vector<double> numbersOf(std::string_view text)
{
    std::vector<double> heights;
    while (!text.empty())
    {
        double number = 0.0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (failure != std::errc() || !std::isfinite(number)) return {};
        heights.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (!text.empty() && text.front() != ';') return {};
        if (!text.empty()) text.remove_prefix(1);
    }
    return heights;
}

/// The heights of a list; none where it does not have one for each point.
std::vector<double> heightsOf(std::string_view text, std::size_t points)
{
    auto heights = numbersOf(text);
    return heights.size() == points ? heights : std::vector<double>();
}

bool isOnSide(std::string_view value, std::string_view side)
{
    return value == side || value == "both";
}

bool isUndergroundLine(const StructureTags& tags)
{
    const auto place = tagOf(tags, "location"), layer = tagOf(tags, "layer");
    return isTagged(tags, "tunnel") || place == "underground" || place == "underwater" ||
           (!layer.empty() && layer.front() == '-' && !isTagged(tags, "bridge"));
}

bool setBarrier(Structure& structure, const StructureTags& tags)
{
    constexpr std::array<std::string_view, 4> kWalls{"wall", "retaining_wall", "city_wall", "yes"};
    const auto barrier = tagOf(tags, "barrier");
    const bool isWall = std::find(kWalls.begin(), kWalls.end(), barrier) != kWalls.end();
    if (!isWall && barrier != "fence" && barrier != "handrail" && barrier != "guard_rail") return false;
    structure.kind = isWall ? StructureKind::wall : StructureKind::fence;
    const bool isOfCity = barrier == "city_wall";
    structure.heightM = metresOf(tags, "height", 0.3, 30.0, isOfCity ? 6.0 : 1.2);
    structure.widthM = metresOf(tags, "width", 0.1, 10.0, isOfCity ? 1.5 : 0.4);
    return true;
}

bool setPower(Structure& structure, const StructureTags& tags)
{
    constexpr double kHighVoltage = 200000.0;
    const auto power = tagOf(tags, "power");
    if (power != "line" && power != "minor_line") return false;
    structure.kind = power == "line" ? StructureKind::powerLine : StructureKind::poleLine;
    const bool isHigh = foundation::numberOfTag(tagOf(tags, "voltage")).value_or(0.0) >= kHighVoltage;
    const double defaultM = power == "minor_line" ? 9.5 : isHigh ? 48.0 : 28.0;
    structure.heightM = metresOf(tags, "height", 5.0, 150.0, defaultM);
    return true;
}

bool setRailway(Structure& structure, const StructureTags& tags)
{
    constexpr std::array<std::string_view, 6> kRailways{"rail",      "narrow_gauge", "light_rail",
                                                        "preserved", "tram",         "subway"};
    if (std::find(kRailways.begin(), kRailways.end(), tagOf(tags, "railway")) == kRailways.end())
        return false;
    structure.kind = StructureKind::railway;
    structure.isBridge = isTagged(tags, "bridge");
    structure.hasWire = tagOf(tags, "electrified") == "contact_line";
    structure.heightM = 0.0;
    structure.heightsM = heightsOf(tagOf(tags, "heights"), structure.line.size());
    structure.isTunnel = isTagged(tags, "tunnel");
    structure.isInStreet = isTagged(tags, "embedded");
    const auto portals = tagOf(tags, "portals"), tube = tagOf(tags, "tube");
    structure.isPortalAtStart = isOnSide(portals, "start"),
    structure.isPortalAtEnd = isOnSide(portals, "end");
    structure.isOpenLeft = isOnSide(tube, "left"), structure.isOpenRight = isOnSide(tube, "right");
    return true;
}

bool setFootbridge(Structure& structure, const StructureTags& tags)
{
    const auto kind = tagOf(tags, "kind");
    if (kind != "footbridge" && kind != "footramp") return false;
    structure.kind = kind == "footbridge" ? StructureKind::footbridge : StructureKind::footRamp;
    structure.heightM = 0.0;
    structure.widthM = metresOf(tags, "width", 0.5, 20.0, 2.5);
    structure.heightsM = heightsOf(tagOf(tags, "heights"), structure.line.size());
    structure.piersM = numbersOf(tagOf(tags, "piers"));
    constexpr double kMostTreads = 500.0;
    const double treads = foundation::numberOfTag(tagOf(tags, "treads")).value_or(0.0);
    if (treads >= 2.0 && treads <= kMostTreads) structure.treads = static_cast<int>(treads);
    return !structure.heightsM.empty();
}

} // namespace

std::optional<Structure> structureOf(std::vector<glm::dvec2> line, const StructureTags& tags,
                                     std::uint64_t id)
{
    Structure structure;
    structure.line = std::move(line);
    structure.id = id;
    if (structure.line.size() == 1)
    {
        const bool isTurbine = tagOf(tags, "generator:source") == "wind" ||
                               tagOf(tags, "kind") == "wind_turbine" ||
                               tagOf(tags, "generator:method") == "wind_turbine";
        if (!isTurbine) return std::nullopt;
        structure.kind = StructureKind::windTurbine;
        structure.heightM =
            metresOf(tags, "height:hub", 15.0, 200.0, metresOf(tags, "height", 15.0, 200.0, 95.0));
        return structure;
    }
    if (structure.line.size() < 2) return std::nullopt;
    if (setFootbridge(structure, tags)) return structure;
    const bool isTube = !tagOf(tags, "heights").empty() && setRailway(structure, tags);
    if (isTube && !structure.heightsM.empty()) return structure;
    if (isUndergroundLine(tags)) return std::nullopt;
    if (setBarrier(structure, tags) || setPower(structure, tags) || setRailway(structure, tags))
        return structure;
    return std::nullopt;
}

} // namespace scenery
