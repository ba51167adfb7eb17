// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Connected faces that a plane sees from their fronts, none before another.
struct Chart
{
    glm::dvec3 right{1.0, 0.0,
                     0.0}; ///< axes of the plane, unit length; it is looked at against cross(right, up)
    glm::dvec3 up{0.0, 1.0, 0.0};
    std::vector<std::uint32_t> faces;

    /// Where a position lies in the plane. Units: as the positions.
    glm::dvec2 flat(const glm::dvec3& p) const { return {glm::dot(p, right), glm::dot(p, up)}; }
};

/// A mesh cut into charts, a parametrisation without stretching besides that of the slant.
/// Invariant: every face is in one chart, and coversFacesOnce() checks it; no two faces of a chart overlap in its plane.
struct Charts
{
    std::vector<Chart> charts;
    std::vector<std::uint32_t> chartOfFace;
};

struct ChartSettings
{
    double mostSlantDeg =
        55.0; ///< of a face against its chart's plane, below 90: 55° stretch texels 1.7 times
};

/// Cuts a mesh into charts: from the largest face that has none, neighbours across edges join, those nearest to the chart's direction
/// first, as long as they are no more aslant than allowed; a second growth, about the mean direction of the first, refuses
/// faces that would lie over others. Faces without area join any chart.
/// Cost: n log n; 10 000 faces in some 20 ms.
/// Source: Sander, Snyder, Gortler and Hoppe, "Texture mapping progressive meshes" (2001), §3.1 (charts grown by planarity);
/// we project each chart instead of solving for its parametrisation, so nothing is minimised and nothing can fold.
Charts makeCharts(const Mesh& mesh, const ChartSettings& settings = {});

/// Whether every face is in exactly one chart, the one that chartOfFace names.
bool coversFacesOnce(const Charts& charts, std::size_t faceCount);

} // namespace osgPMObjects::core
