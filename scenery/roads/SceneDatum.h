// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include <osgRoads/core/place/RoadDatum.h>

#include "scenery/roads/GroundProfiles.h"
#include "scenery/roads/PlanMap.h"

namespace scenery
{

/// Lays a network into a scene: its plan by a PlanMap; its heights are the file's, counted from zero or from
/// profiles on the ground.
/// Units: metres. Threads: const, any.
class SceneDatum : public osgRoads::core::RoadDatum
{
public:
    explicit SceneDatum(PlanMap map, std::shared_ptr<const GroundProfiles> base = nullptr)
        : _map(std::move(map)), _base(std::move(base))
    {
    }

    glm::dvec3 toScene(const osgRoads::core::RoadPosition& position,
                       const glm::dvec3& inertial) const override;
    /// The height is that above the zero of the file's heights, or above the smoothed ground.
    glm::dvec3 toInertial(const glm::dvec3& scene) const override;

private:
    PlanMap _map;
    std::shared_ptr<const GroundProfiles> _base; ///< null: heights are the file's
};

} // namespace scenery
