// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "scenery/roads/RoadBand.h"

namespace scenery
{

/// How far the ground has to rise or fall beside roads, so that it meets the outer edges of all their verges.
/// At an edge the rise is that of the edge above the ground; away from edges it is their weighted mean, which
/// falls to zero over a length that grows with it. So the ground between two streets is a smooth surface
/// between their edges, whatever their heights are, and that beside one street goes over into the ground as
/// it was, at most some 0.5 steeper than that.
/// Frame: the scene's, x and y. Units: metres. Threads: const, any. Memory: 32 B for each 3 m of edge.
/// Source: Franke & Nielson, *Smooth interpolation of large sets of scattered data*, 1980 (weights that end
/// at a radius); the weights fall with the fifth power of the distance, so that along a line of points they
/// fall with its fourth: between two edges hardly anything of the ground as it was is left.
class RoadEdges
{
public:
    /// Looks at the ground as it is. Edges on bridges, in tunnels and on torn roads, and those that other
    /// roads cover, do not count.
    /// Cost: some 20 µs for each 3 m of road, in as many threads as the processor has, 8 at most.
    RoadEdges(const osgRoads::core::PlacedNetwork& roads, const osgTerrainROAM::core::PlacedTile& tile,
              const RoadCutShape& shape);

    /// Returns by how much the ground rises at a place beyond the verges.
    double riseAt(const glm::dvec2& place) const;

    /// The length from an edge beyond which a rise there does not matter.
    static double reachOf(double riseM, const RoadCutShape& shape);

    std::size_t size() const { return _points.size(); }

private:
    struct Point
    {
        glm::dvec2 place{0.0};
        float riseM = 0.0F, wideM = 0.0F, reachM = 0.0F, shareM = 0.0F; ///< shareM: of the edge's length
    };
    struct Site; ///< a place of an edge, and its height

    static std::vector<Site> sitesOf(const osgRoads::core::PlacedNetwork& roads, int road,
                                     const RoadCutShape& shape);
    static bool isFree(const osgRoads::core::PlacedNetwork& roads, const Site& site,
                       const RoadCutShape& shape);
    void fillCells();

    std::vector<Point> _points;                                                        ///< cell by cell
    std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> _cells; ///< first and end
};

} // namespace scenery
