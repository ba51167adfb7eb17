// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/common.hpp>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "ChunkBuilder.h"
#include "ChunkCuts.h"

namespace osgRoads::core
{

namespace
{

/// The middle of where the roads begin, in whole metres.
glm::dvec3 originOf(const PlacedNetwork& network)
{
    glm::dvec3 least(1e300), most(-1e300);
    for (std::size_t i = 0; i < network.network().roads.size(); ++i)
    {
        if (!network.network().roads[i].isUsable) continue;
        const glm::dvec3 start = network.point({static_cast<int>(i), 0.0, 0.0, 0.0});
        least = glm::min(least, start);
        most = glm::max(most, start);
    }
    return least.x > most.x ? glm::dvec3(0.0) : glm::round(0.5 * (least + most));
}

} // namespace

RoadMeshSettings meshSettingsFor(const RoadNetwork& network)
{
    constexpr double kLongestM = 3e5, kCoarsestM = 0.01;
    RoadMeshSettings settings;
    settings.errorM =
        std::clamp(settings.errorM * network.usableLengthM() / kLongestM, settings.errorM, kCoarsestM);
    return settings;
}

RoadMesh buildRoadMesh(const PlacedNetwork& network, const RoadMeshSettings& settings)
{
    RoadMesh mesh;
    mesh.origin = originOf(network);
    MarkRows marks;
    DecalRows decals(network, mesh.origin);
    for (std::size_t i = 0; i < network.network().roads.size(); ++i)
    {
        const Road& road = network.network().roads[i];
        if (!road.isUsable) continue;
        for (const LaneSection& section : road.sections)
        {
            const std::vector<double> cuts = chunkCuts(road, section, settings.chunkM);
            ChunkBuilder builder(network, static_cast<int>(i), section, settings, marks, decals, mesh);
            for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut)
                builder.add(cuts[cut], cuts[cut + 1]);
        }
    }
    mesh.marks = marks.take();
    mesh.decals = decals.take();
    return mesh;
}

} // namespace osgRoads::core
