// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/surface/RoadView.h>

#include "ChunkLevels.h"

namespace osgRoads::core
{

namespace
{

/// A corner of a triangle: its place and MeshVertex::present.
struct Corner
{
    glm::dvec3 place{0.0};
    double present = 0.0;
};

/// Returns the height of a triangle above a point of the plan view, where it is drawn.
std::optional<double> heightIn(const std::array<Corner, 3>& corners, glm::dvec2 at)
{
    const glm::dvec2 a(corners[0].place), ab = glm::dvec2(corners[1].place) - a,
                                          ac = glm::dvec2(corners[2].place) - a;
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (!(std::fabs(area) > 1e-12)) return std::nullopt;
    const glm::dvec2 to = at - a;
    const double b = (to.x * ac.y - to.y * ac.x) / area, c = (ab.x * to.y - ab.y * to.x) / area;
    constexpr double kEdge = 1e-9, kCut = 127.5;
    if (b < -kEdge || c < -kEdge || b + c > 1.0 + kEdge) return std::nullopt;
    const auto between = [&](double first, double second, double third)
    { return first + b * (second - first) + c * (third - first); };
    if (between(corners[0].present, corners[1].present, corners[2].present) < kCut) return std::nullopt;
    return between(corners[0].place.z, corners[1].place.z, corners[2].place.z);
}

} // namespace

std::vector<ChunkChoice> chooseLevels(const RoadMesh& mesh, const viewlod::ViewState& view,
                                      const RoadViewSettings& settings)
{
    std::vector<ChunkChoice> choices;
    for (std::size_t i = 0; i < mesh.chunks.size(); ++i)
    {
        const RoadChunk& chunk = mesh.chunks[i];
        if (!isNear(view, chunk.centre, chunk.radius, settings.farthestM)) continue;
        if (view.frustum.classify(chunk.centre, chunk.radius).outside) continue;
        choices.push_back({static_cast<std::uint32_t>(i), coarsestLevel(chunk, view, settings)});
    }
    return choices;
}

double liftAt(double distanceM, const viewlod::ViewState& view, const RoadViewSettings& settings)
{
    const double share =
        std::clamp((distanceM - settings.liftFromM) / (settings.liftFullM - settings.liftFromM), 0.0, 1.0);
    return settings.liftPx / view.pixelsPerTangent * distanceM * share * share * (3.0 - 2.0 * share);
}

std::optional<double> drawnHeight(const RoadMesh& mesh, const std::vector<ChunkChoice>& choices,
                                  const viewlod::ViewState& view, const RoadViewSettings& settings,
                                  glm::dvec2 at, double below)
{
    std::optional<double> highest;
    for (const ChunkChoice& choice : choices)
    {
        const RoadChunk& chunk = mesh.chunks[choice.chunk];
        if (glm::distance(at, glm::dvec2(chunk.centre)) > chunk.radius) continue;
        const ChunkLevel& level = chunk.levels[choice.level];
        for (std::uint32_t i = level.firstIndex; i < level.firstIndex + level.indexCount; i += 3)
        {
            std::array<Corner, 3> corners;
            for (std::uint32_t j = 0; j < 3; ++j)
            {
                const MeshVertex& vertex = mesh.vertices[mesh.indices[i + j]];
                corners[j] = {mesh.placeOf(vertex), static_cast<double>(vertex.present)};
                corners[j].place.z += liftAt(glm::distance(corners[j].place, view.eyeWorld), view, settings);
            }
            const std::optional<double> height = heightIn(corners, at);
            if (height && *height <= below && (!highest || *height > *highest)) highest = height;
        }
    }
    return highest;
}

} // namespace osgRoads::core
