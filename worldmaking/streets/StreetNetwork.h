// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/streets/BuildStreets.h"
#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/ConnectingRoad.h"
#include "worldmaking/streets/CornerEdge.h"
#include "worldmaking/streets/LaneLayout.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/Turns.h"

namespace worldmaking
{

/// Puts the parts of streets together to the roads and junctions of a network. The road of chain i has the id
/// i; junctions and connecting roads have ids after them.
class StreetNetwork
{
public:
    StreetNetwork(const StreetMap& map, const StreetGraph& graph, const std::vector<CentreLine>& lines,
                  const std::vector<ChainCut>& cuts, const StreetHeights& heights)
        : _map(map), _graph(graph), _lines(lines), _cuts(cuts), _heights(heights)
    {
    }

    void build(osgRoads::core::RoadNetwork& network, StreetReport& report) const;

private:
    /// A lane at the mouth of a road.
    struct Gate
    {
        int laneId = 0;
        LaneGate gate;
    };
    /// An arm of a crossing with its lanes, from the middle of the road outwards.
    struct Arm
    {
        StreetArm arm;
        std::vector<Gate> in, out;
        ArmSides sides;
    };
    /// A crossing with its arms, in the order of the map.
    struct ArmsOfCrossing
    {
        std::size_t index = 0;
        std::vector<Arm> arms;
        glm::dvec2 middle{0.0};
    };

    osgRoads::core::Road roadOf(std::size_t chain, StreetReport& report) const;
    std::vector<LayoutPart> layoutParts(std::size_t chain, double lengthM) const;
    void addKinds(std::size_t chain, osgRoads::core::Road& road) const;
    void addStructures(std::size_t chain, osgRoads::core::Road& road, StreetReport& report) const;
    void measure(std::size_t chain, const osgRoads::core::Road& road, StreetReport& report) const;
    double placeOf(std::size_t chain, std::size_t point, double lengthM) const;
    std::string junctionId(int crossing) const;

    Arm armOf(const StreetArm& arm, const osgRoads::core::Road& road) const;
    std::vector<char> allowedTurns(const Crossing& crossing) const;
    bool isAllowed(const Crossing& crossing, const StreetArm& from, const StreetArm& to) const;
    StreetPlace placeAt(const StreetArm& arm) const;
    ArmsOfCrossing armsOf(std::size_t crossing, const osgRoads::core::RoadNetwork& network) const;
    std::vector<std::size_t> neighboursOf(const ArmsOfCrossing& crossing) const;
    osgRoads::core::Road roadAcross(const ArmsOfCrossing& crossing, std::size_t from, std::size_t to,
                                    const LaneGate& start, const LaneGate& end) const;
    void addTurns(const ArmsOfCrossing& crossing, const std::vector<std::size_t>& neighbours,
                  osgRoads::core::RoadNetwork& network, StreetReport& report) const;
    void addCorners(const ArmsOfCrossing& crossing, const std::vector<std::size_t>& neighbours,
                    const std::vector<char>& hasEdge, osgRoads::core::RoadNetwork& network) const;
    void addJunction(std::size_t crossing, osgRoads::core::RoadNetwork& network, StreetReport& report) const;

    const StreetMap& _map;
    const StreetGraph& _graph;
    const std::vector<CentreLine>& _lines;
    const std::vector<ChainCut>& _cuts;
    const StreetHeights& _heights;
};

} // namespace worldmaking
