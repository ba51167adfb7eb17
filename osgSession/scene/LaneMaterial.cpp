// SPDX-License-Identifier: Apache-2.0
#include "LaneMaterial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>

namespace trainer
{

namespace
{

using simulation::GroundKind;

constexpr std::array<std::pair<std::string_view, GroundKind>, 14> kLaneSurfaces{
    {{"asphalt", GroundKind::asphalt},
     {"concrete", GroundKind::asphalt},
     {"pavement", GroundKind::asphalt},
     {"cobble", GroundKind::asphalt},
     {"wet", GroundKind::wetAsphalt},
     {"gravel", GroundKind::gravel},
     {"dirt", GroundKind::gravel},
     {"sand", GroundKind::gravel},
     {"rock", GroundKind::gravel},
     {"grass", GroundKind::grass},
     {"soil", GroundKind::grass},
     {"snow", GroundKind::snow},
     {"ice", GroundKind::ice},
     {"water", GroundKind::water}}};

bool saysMaterial(const std::vector<osgRoads::core::Lane>& lanes)
{
    return std::any_of(lanes.begin(), lanes.end(),
                       [](const osgRoads::core::Lane& lane) { return !lane.materials.empty(); });
}

} // namespace

std::optional<GroundKind> groundKindOf(std::string_view surface)
{
    for (const auto& [name, kind] : kLaneSurfaces)
        if (name == surface) return kind;
    return std::nullopt;
}

bool hasMaterials(const osgRoads::core::RoadNetwork& network)
{
    for (const osgRoads::core::Road& road : network.roads)
        for (const osgRoads::core::LaneSection& section : road.sections)
            if (saysMaterial(section.left) || saysMaterial(section.right)) return true;
    return false;
}

/// Of roads over each other the one that is nearest in height.
std::optional<GroundKind> laneMaterialAt(const osgRoads::core::PlacedNetwork& roads, const glm::dvec3& point)
{
    constexpr double kOnLanesM = 1e-6;
    std::optional<GroundKind> kind;
    double nearestM = 1e9;
    for (const osgRoads::core::RoadMatch& match :
         roads.locator().within(glm::dvec2(roads.toInertial(point)), kOnLanesM))
    {
        const auto& [index, s, t, h] = match.position;
        const double awayM = std::abs(roads.surfacePoint(index, s, t).z - point.z);
        if (awayM >= nearestM) continue;
        nearestM = awayM;
        kind.reset();
        const osgRoads::core::Road& road = roads.road(index);
        const auto span = osgRoads::core::laneAt(road, s, t);
        const auto* const section = osgRoads::core::sectionAt(road, s);
        if (!span || !section) continue;
        for (const osgRoads::core::LaneRule& material : span->lane->materials)
            if (material.s <= s - section->s) kind = groundKindOf(material.restriction);
    }
    return kind;
}

} // namespace trainer
