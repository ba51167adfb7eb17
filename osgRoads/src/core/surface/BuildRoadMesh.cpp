// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <foundation/ForEachAtOnce.h>
#include <glm/common.hpp>

#include <osgRoads/core/read/Problem.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "ChunkBuilder.h"
#include "ChunkCuts.h"
#include "MeshJoiner.h"

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

/// So many roads are meshed by one thread at a time, and so many parts before they are joined. The mesh
/// depends on the former (equal marks of two parts are two rows), not on the number of threads.
constexpr std::size_t kRoadsOfPart = 64, kPartsAtOnce = 16;

/// A range of roads.
struct RoadSpan
{
    std::size_t first = 0, end = 0;
};

RoadMesh buildPart(const PlacedNetwork& network, const RoadMeshSettings& settings, const DecalFinder& finder,
                   const glm::dvec3& origin, const RoadSpan& span)
{
    RoadMesh mesh;
    mesh.origin = origin;
    MarkRows marks;
    DecalRows decals(finder, origin);
    for (std::size_t i = span.first; i < span.end; ++i)
    {
        const Road& road = network.network().roads[i];
        if (!road.isUsable) continue;
        const OpenEnds ends(network, static_cast<int>(i));
        for (const LaneSection& section : road.sections)
        {
            const std::vector<double> cuts = chunkCuts(road, section, ends.cuts(), settings.chunkM);
            ChunkBuilder builder(network, static_cast<int>(i), section, ends, settings, marks, decals, mesh);
            for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut)
                builder.add(cuts[cut], cuts[cut + 1]);
        }
    }
    mesh.marks = marks.take();
    mesh.decals = decals.take();
    return mesh;
}

std::vector<RoadSpan> partsOf(const RoadNetwork& network)
{
    std::vector<RoadSpan> spans;
    for (std::size_t first = 0; first < network.roads.size(); first += kRoadsOfPart)
        spans.push_back({first, std::min(first + kRoadsOfPart, network.roads.size())});
    return spans;
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
    const std::vector<RoadSpan> spans = partsOf(network.network());
    MeshJoiner joiner(originOf(network), spans.size());
    const DecalFinder decals(network);
    std::vector<RoadMesh> parts;
    for (std::size_t first = 0; first < spans.size(); first += kPartsAtOnce)
    {
        parts.resize(std::min(kPartsAtOnce, spans.size() - first));
        foundation::forEachAtOnce(
            parts.size(), [&](std::size_t i)
            { parts[i] = buildPart(network, settings, decals, joiner.origin(), spans[first + i]); });
        for (RoadMesh& part : parts)
            joiner.add(std::exchange(part, {}));
    }
    return joiner.take();
}

std::string unreachedMessage(const RoadMesh& mesh, const RoadNetwork& network, const std::string& file)
{
    if (mesh.unreached.empty()) return {};
    const Road& first = network.roads[static_cast<std::size_t>(mesh.unreached.front())];
    const std::size_t others = mesh.unreached.size() - 1;
    return file + ":" + std::to_string(first.line) + ": road " + first.id +
           (others > 0 ? " and " + std::to_string(others) + " more" : "") + " not drawn where " +
           (others > 0 ? "they lie" : "it lies") + " more than " + shortNumber(RoadMesh::kReachM / 1000.0) +
           " km from the middle of the network; split the network, or correct x, y and elevation";
}

} // namespace osgRoads::core
