// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "simulation/player/SceneFrame.h"
#include "simulation/road/RoadScene.h"
#include "simulation/state/EntityState.h"

namespace simulation
{

/// Where and how something is put. Frame: the scene's; angles as in EntityState, in radians.
struct Placement
{
    glm::dvec3 position{0.0};
    double headingRad = 0.0, pitchRad = 0.0, rollRad = 0.0;
    bool hasHeading = false;        ///< the position gives it
    std::optional<RoadPlace> place; ///< on the road network
};

/// Finds the places that the positions of a scenario mean, at the time of the question.
/// Source: ASAM OpenSCENARIO XML 1.3, Position and Orientation.
class PositionSolver
{
public:
    using Lookup = std::function<const EntityState*(const std::string& entity)>;

    /// `roads` may be null: positions on roads then have no place.
    PositionSolver(const SceneFrame& frame, const RoadScene* roads, Lookup states)
        : _frame(&frame), _roads(roads), _states(std::move(states))
    {
    }

    /// Returns nothing for a position that cannot be placed: no such road, lane or entity, no georeference.
    std::optional<Placement> place(const Position& position) const;

private:
    std::optional<Placement> onRoad(const std::optional<RoadPlace>& place,
                                    const Orientation& orientation) const;
    Placement inWorld(const glm::dvec3& point, const Orientation& orientation, double baseHeadingRad) const;
    std::optional<Placement> placeAtEntity(const RoutePosition& position) const;
    std::optional<Placement> placeOnTrajectory(const TrajectoryPosition& position) const;
    std::optional<Placement> placeRelative(const RelativeLanePosition& position) const;
    std::optional<Placement> placeRelative(const RelativeRoadPosition& position) const;
    std::optional<Placement> placeRelative(const RelativeObjectPosition& position) const;
    std::optional<Placement> placeRelative(const RelativeWorldPosition& position) const;

    const SceneFrame* _frame;
    const RoadScene* _roads;
    Lookup _states;
};

} // namespace simulation
