// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/place/RoadDatum.h>

#include "scenery/roads/BaseSurface.h"
#include "scenery/roads/PlanMap.h"

namespace scenery
{

/// Lays a network into a scene: its plan by a PlanMap; its heights are the file's, counted from zero or from a base surface.
/// The base of a cross-section is that below the reference line, so that no road leans with the hillside. Within kBlendM of a
/// junction it goes over to the base below each point, which all roads that meet there have in common.
/// Units: metres. Threads: const, any.
class SceneDatum : public osgRoads::core::RoadDatum
{
public:
    static constexpr double kBlendM = 40.0;

    SceneDatum(std::shared_ptr<const osgRoads::core::RoadNetwork> network, PlanMap map,
               std::optional<BaseSurface> base = std::nullopt)
        : _network(std::move(network)), _map(std::move(map)), _base(std::move(base))
    {
    }

    glm::dvec3 toScene(const osgRoads::core::RoadPosition& position,
                       const glm::dvec3& inertial) const override;
    glm::dvec3 toInertial(const glm::dvec3& scene) const override;

private:
    double baseM(const osgRoads::core::RoadPosition& position, const glm::dvec2& plan) const;

    std::shared_ptr<const osgRoads::core::RoadNetwork> _network;
    PlanMap _map;
    std::optional<BaseSurface> _base; ///< absent: heights are the file's
};

} // namespace scenery
