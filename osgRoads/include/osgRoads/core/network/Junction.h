// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/network/LaneType.h>

namespace osgRoads::core
{

enum class ContactPoint
{
    start,
    end,
};

inline constexpr Keywords<ContactPoint, 2> kContactPoints = {
    {{"start", ContactPoint::start}, {"end", ContactPoint::end}}};

enum class JunctionType
{
    common,
    direct,   ///< roads meet without connecting roads
    isVirtual ///< on a road that is not cut
};

inline constexpr Keywords<JunctionType, 4> kJunctionTypes = {{{"default", JunctionType::common},
                                                              {"common", JunctionType::common},
                                                              {"direct", JunctionType::direct},
                                                              {"virtual", JunctionType::isVirtual}}};

/// How one comes from one road to another within a junction.
struct JunctionConnection
{
    struct LaneLink
    {
        int from = 0, to = 0; ///< lane of the incoming road, lane of the connecting (or linked) road
    };

    std::string id;
    std::string incomingRoadId,
        connectingRoadId; ///< of a direct junction, the linked road is the connecting one
    int incomingRoad = -1, connectingRoad = -1;      ///< indices into RoadNetwork::roads, -1: there is none
    ContactPoint contactPoint = ContactPoint::start; ///< where the connecting road touches the incoming one
    std::vector<LaneLink> laneLinks;
    int line = 0;
};

/// Roads that meet. Source: ASAM OpenDRIVE 1.8, 12.
struct Junction
{
    struct Priority
    {
        std::string high, low; ///< ids of roads
    };

    std::string id, name;
    JunctionType type = JunctionType::common;
    std::string mainRoadId; ///< of a virtual junction, with its range
    double sStart = 0.0, sEnd = 0.0;
    std::vector<JunctionConnection> connections;
    std::vector<Priority> priorities;
    std::vector<std::string> controllerIds;
    int line = 0;
};

} // namespace osgRoads::core
