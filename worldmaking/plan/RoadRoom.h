// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/query/RoadLocator.h>

namespace worldmaking
{

using PlanRings = std::vector<std::vector<glm::dvec2>>;

/// Tells how much room roads leave: those on the ground and on bridges, not those in tunnels. Frame:
/// inertial. Units: metres.
class RoadRoom
{
public:
    /// `network` must stay as it is while the room is used.
    explicit RoadRoom(const osgRoads::core::RoadNetwork& network) : _network(network), _locator(network) {}

    /// Returns the distance from the lanes of the nearest road; `withinM` where none is nearer.
    double distanceM(const glm::dvec2& place, double withinM) const;

    /// Cuts an outline back until it is `roomM` from all lanes. Nothing: less than `leastShare` of its area
    /// is left.
    std::optional<PlanRings> cutBack(PlanRings rings, double roomM, double leastShare) const;

    /// Returns the least distance of an outline's edges from lanes, looked at every metre; `withinM` where
    /// none is nearer.
    double distanceM(const PlanRings& rings, double withinM) const;

private:
    std::optional<osgRoads::core::RoadMatch> nearest(const glm::dvec2& place, double withinM) const;

    const osgRoads::core::RoadNetwork& _network;
    osgRoads::core::RoadLocator _locator;
};

} // namespace worldmaking
