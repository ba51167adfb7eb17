// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "simulation/road/RoadScene.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// The ground of a road network without terrain: asphalt on the lanes, and grass beside them that goes on as
/// the road leans. Where roads lie over each other it is the nearest one by its height. Cost: about a
/// microsecond a point.
class RoadSceneGround final : public Ground
{
public:
    explicit RoadSceneGround(std::shared_ptr<const RoadScene> roads) : _roads(std::move(roads)) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override;

private:
    std::shared_ptr<const RoadScene> _roads;
};

} // namespace simulation
