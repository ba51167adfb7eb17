// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// The header of a file. Source: ASAM OpenDRIVE 1.8, 6 and 8.5 (georeferencing).
struct NetworkHeader
{
    int revMajor = 1, revMinor = 4;
    std::string name, version, date, vendor;
    std::string geoReference; ///< for PROJ; empty: none
    double offsetX = 0.0, offsetY = 0.0, offsetZ = 0.0, offsetHeadingRad = 0.0;
};

/// The roads and junctions of one OpenDRIVE file.
/// Frame: inertial, x east, y north, z up, metres.
/// Threads: any number may read; nothing changes after reading.
class RoadNetwork
{
public:
    NetworkHeader header;
    std::vector<Road> roads;
    std::vector<Junction> junctions;
    std::vector<Controller> controllers;

    /// Returns an index, or -1. Valid after index().
    int roadIndex(const std::string& id) const { return find(_roads, id); }
    int junctionIndex(const std::string& id) const { return find(_junctions, id); }

    /// Returns the length of all roads that can be used, metres.
    double usableLengthM() const
    {
        double lengthM = 0.0;
        for (const Road& road : roads)
            lengthM += road.isUsable ? road.length : 0.0;
        return lengthM;
    }

    /// Makes the tables of ids. Of equal ids the first one counts.
    void index()
    {
        for (std::size_t i = 0; i < roads.size(); ++i)
            _roads.emplace(roads[i].id, static_cast<int>(i));
        for (std::size_t i = 0; i < junctions.size(); ++i)
            _junctions.emplace(junctions[i].id, static_cast<int>(i));
    }

private:
    using Table = std::unordered_map<std::string, int>;

    static int find(const Table& table, const std::string& id)
    {
        const auto found = table.find(id);
        return found == table.end() ? -1 : found->second;
    }

    Table _roads, _junctions;
};

} // namespace osgRoads::core
