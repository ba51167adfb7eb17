// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include <osgTerrainROAM/core/bisection/BisectionBounds.h>

#include "../RoundedUp.h"

namespace osgTerrainROAM::core
{

BisectionBounds::BisectionBounds(const BisectionSurface& surface, std::span<const BisectionPatch> patches)
    : _surface(surface), _errors(surface.vertices(), 0.0f), _radii(surface.vertices(), 0.0f)
{
    const CarrierTable carriers(patches);
    for (int level = surface.levels(); level-- > 0;)
        for (std::uint32_t side = 0; side < surface.mesh().sides(); ++side)
            for (std::uint32_t node = 1u << level; node < 2u << level; ++node)
                measure({side, node}, patches, carriers);
}

void BisectionBounds::measure(Bisector t, std::span<const BisectionPatch> patches,
                              const CarrierTable& carriers)
{
    const BisectorNeighbours at = neighboursOf(_surface.mesh(), t);
    const std::uint32_t vertex = _surface.vertexOf(at);
    const glm::dvec3& centre = _surface.point(vertex);
    const CornerVertices corners = _surface.cornersOf(t);
    double error = _errors[vertex], radius = _radii[vertex];
    const auto meet = [&](const glm::dvec3& weights, const glm::dvec3& point)
    {
        const glm::dvec3 flat = weights.x * _surface.point(corners[0]) +
                                weights.y * _surface.point(corners[1]) +
                                weights.z * _surface.point(corners[2]);
        error = std::max(error, glm::distance(point, flat));
    };
    const auto meetBelow =
        [&](const BisectorNeighbours& below, std::uint32_t sample, const CornerWeights& own)
    {
        const std::uint32_t patch = carriers.at(below.self);
        if (patch == kNoSide)
            meet(middleOf(own), _surface.point(sample));
        else
            for (const PatchPoint& p : patches[patch].points)
                meet(p.weights.x * own[0] + p.weights.y * own[1] + p.weights.z * own[2], p.point);
        return patch == kNoSide;
    };
    if (!carriers.isBelowCarrier(t)) _surface.visitWeighted(at, kOwnCorners, meetBelow);
    if (const std::uint32_t patch = carriers.at(t); patch != kNoSide)
        for (const PatchPoint& p : patches[patch].points)
            radius = std::max(radius, glm::distance(centre, p.point));
    if (t.level() + 1 < _surface.levels())
        for (const unsigned which : {0u, 1u})
        {
            const std::uint32_t below = _surface.vertexOf(at.half(which));
            error = std::max(error, static_cast<double>(_errors[below]));
            radius = std::max(radius, glm::distance(centre, _surface.point(below)) + _radii[below]);
        }
    _errors[vertex] = roundedUp(error);
    _radii[vertex] = roundedUp(radius);
}

bool BisectionBounds::isActive(std::uint32_t vertex, const BisectionView& view) const
{
    const double distance = glm::distance(view.eye, _surface.point(vertex)) - _radii[vertex];
    return _errors[vertex] > view.tolerance * std::max(distance, view.nearest);
}

} // namespace osgTerrainROAM::core
