// SPDX-License-Identifier: Apache-2.0
#include "worldtool/FaultLines.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace worldtool
{

namespace
{

using osgTerrainROAM::core::PlacedTile;
using worldmaking::CrossingFault;
using worldmaking::CrossingFlaw;

std::string number(double value, const char* format)
{
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string placeOf(const PlacedTile& tile, const glm::dvec3& scene)
{
    if (tile.frame().placement() != osgTerrainROAM::core::Placement::curved)
        return number(scene.x, "x %.1f m, ") + number(scene.y, "y %.1f m");
    const auto at = tile.frame().geodeticFromLocal(scene);
    return number(at.latitudeDeg, "%.5f, ") + number(at.longitudeDeg, "%.5f");
}

/// Writes lines, kind by kind.
class LineWriter
{
public:
    LineWriter(const osgRoads::core::PlacedNetwork* roads, const PlacedTile& tile)
        : _roads(roads), _tile(tile)
    {
    }

    void addCrossing(const CrossingFault& fault)
    {
        switch (fault.flaw)
        {
        case CrossingFlaw::roads:
            return add(
                fault.place, road(fault.road) + " passes over " + road(fault.other) + " with " + clear(fault),
                "give the upper one a bridge with a longer approach, or the lower one a tunnel; join other "
                "streets farther away");
        case CrossingFlaw::rails:
            return add(fault.place,
                       road(fault.road) + (fault.isRoadAbove ? " passes over" : " passes under") +
                           " a railway with " + clear(fault),
                       "give one of them bridge=yes and a layer, or both a common node where they cross on "
                       "one level");
        case CrossingFlaw::tunnel:
            return add(fault.place,
                       "the tunnel of " + (fault.road < 0 ? "a railway" : road(fault.road)) + " stands " +
                           number(fault.foundM, "%.1f m") + " above the ground",
                       "join other streets farther from its portals, so that ramps have room, or take the "
                       "tunnel off "
                       "the map");
        case CrossingFlaw::footbridge:
            return add(fault.place,
                       "a footbridge passes " + std::string(fault.isRoadAbove ? "under " : "over ") +
                           road(fault.road) + " with " + clear(fault),
                       "give its way and the street layers that tell which is above, and its path room for a "
                       "ramp or stairs");
        case CrossingFlaw::lines:
            return add(fault.place,
                       std::string(fault.isUpperFootbridge ? "a footbridge" : "a railway") + " passes over " +
                           (fault.isLowerFootbridge ? "a footbridge" : "a railway") + " with " + clear(fault),
                       "give both ways layers that tell which is above, and the upper one a longer approach");
        case CrossingFlaw::railEnd:
            if (fault.road < 0)
                return add(fault.place, "rails meet in a step of " + number(fault.foundM, "%.1f m"),
                           "build the world anew");
            return add(fault.place, "rails end at " + road(fault.road),
                       "lead the railway on below or over it in the map");
        }
    }

    void addJunction(const worldmaking::JunctionFault& fault)
    {
        if (fault.flaw == worldmaking::JunctionFlaw::step)
            add(fault.place,
                road(fault.road) + " lies " + number(fault.by, "%.2f m") + " off " + road(fault.other) +
                    " where both cross",
                "give both a node in common in the map, or one of them bridge=yes and a layer");
        else
            add(fault.place,
                "the crossing of " + road(fault.road) + " leans by " + number(100.0 * fault.by, "%.0f %%"),
                "give finer elevation data, or lead the steeper street in along the slope");
    }

    void addRoad(const worldmaking::RoadFault& fault)
    {
        add(fault.place,
            road(fault.road) + (fault.isSunk ? " is covered by " : " lies above the ground by ") +
                number(fault.byM, "%.1f m") + (fault.isSunk ? " of ground" : "") +
                (fault.other >= 0 ? ", beside " + road(fault.other) : std::string()),
            fault.other >= 0 ? "move the two apart in the map, or give the upper one bridge=yes"
                             : "build the world anew; if it stays, give finer elevation data");
    }

    void addHouse(const worldmaking::HouseFault& fault)
    {
        using Flaw = worldmaking::HouseFault::Flaw;
        if (fault.flaw == Flaw::beyond)
            return add(fault.place, "a house reaches beyond the elevation data",
                       "give elevation data around it, or cut the map (--bounds)");
        const std::string by = number(std::abs(fault.byM), "%.1f m ") + (fault.byM < 0.0 ? "below" : "above");
        add(fault.place,
            (fault.flaw == Flaw::floats ? "the walls of a house end " : "the eaves of a house lie ") + by +
                " its lowest ground",
            "build the world anew; if it stays, give finer elevation data");
    }

    void addWater(const worldmaking::WaterFault& fault)
    {
        const auto& figures = fault.figures;
        const bool isSteep = figures.slope > 0.0;
        std::string what = "water " + (fault.name.empty() ? "" : "'" + fault.name + "' ") + "of " +
                           number(fault.areaM2, "%.0f m²");
        if (!figures.isKnown)
            what += " reaches beyond the elevation data";
        else
            what += " does not lie level: slope " + number(100.0 * figures.slope, "%.0f %%") + ", fall " +
                    number(100.0 * figures.fall, "%.0f %%") + ", rise " +
                    number(100.0 * figures.rise, "%.0f %%") + ", " +
                    number(100.0 * figures.lowShore, "%.0f %% of its shore low");
        add(isSteep && figures.isKnown ? glm::dvec3(figures.steepAt, 0.0) : glm::dvec3(fault.place, 0.0),
            what,
            figures.isKnown ? "give a river a line (waterway) along its course, downstream, a lake an "
                              "outline that keeps off "
                              "slopes and roads, or finer elevation data"
                            : "give elevation data around it, or cut the map (--bounds)");
    }

    /// Ends a kind.
    void close(const char* kind)
    {
        if (_count > kMostFaultLines) lines.push_back(std::to_string(_count) + " " + kind + " in all");
        _count = 0;
    }

    std::vector<std::string> lines;

private:
    void add(const glm::dvec3& place, const std::string& what, const std::string& remedy)
    {
        if (++_count <= kMostFaultLines) lines.push_back(placeOf(_tile, place) + ": " + what + "; " + remedy);
    }

    std::string road(int index) const
    {
        const auto& plain = _roads->road(index);
        return "road " + plain.id + (plain.name.empty() ? "" : " '" + plain.name + "'");
    }

    static std::string clear(const CrossingFault& fault)
    {
        return number(std::max(0.0, fault.foundM), "%.1f m clear instead of ") +
               number(fault.wantedM, "%.1f m");
    }

    const osgRoads::core::PlacedNetwork* _roads;
    const PlacedTile& _tile;
    std::size_t _count = 0;
};

} // namespace

std::vector<std::string> faultLines(const worldmaking::WorldFaults& faults,
                                    const osgRoads::core::PlacedNetwork* roads, const PlacedTile& tile)
{
    LineWriter writer(roads, tile);
    for (const auto& fault : faults.crossingFaults)
        writer.addCrossing(fault);
    writer.close("faults of crossings");
    for (const auto& fault : faults.junctionFaults)
        writer.addJunction(fault);
    writer.close("uneven junctions");
    for (const auto& fault : faults.roadFaults)
        writer.addRoad(fault);
    writer.close("roads that the ground leaves or covers");
    for (const auto& fault : faults.houseFaults)
        writer.addHouse(fault);
    writer.close("houses that do not stand on their ground");
    for (const auto& fault : faults.waterFaults)
        writer.addWater(fault);
    writer.close("uneven waters");
    return std::move(writer.lines);
}

} // namespace worldtool
