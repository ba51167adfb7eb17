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

/// A connected set of faces that project onto a plane with their fronts, without overlap.
struct Chart
{
    glm::dvec3 right{1.0, 0.0, 0.0}; ///< plane axes, unit length; the view direction is -cross(right, up)
    glm::dvec3 up{0.0, 1.0, 0.0};
    std::vector<std::uint32_t> faces;

    /// Projects a position into the plane. Units: as the positions.
    glm::dvec2 flat(const glm::dvec3& p) const { return {glm::dot(p, right), glm::dot(p, up)}; }
};

/// A mesh divided into charts: a parametrisation whose only distortion is that of the projection.
/// Invariant: every face is in one chart (coversFacesOnce()); no two faces of a chart overlap in its plane.
struct Charts
{
    std::vector<Chart> charts;
    std::vector<std::uint32_t> chartOfFace;
};

struct ChartSettings
{
    double mostSlantDeg =
        55.0; ///< between a face and its chart's plane, below 90: 55° stretch texels 1.7 times
};

/// Divides a mesh into charts. A chart starts with the largest face that has none; neighbours across edges
/// join, nearest in direction first, up to the allowed slant. It is then grown again about the mean direction
/// of this first set, without faces that would overlap others. Faces without area join any chart.
/// Cost: n log n; 10 000 faces in some 20 ms.
/// Source: Sander, Snyder, Gortler and Hoppe, *Texture mapping progressive meshes* (2001), section 3.1
/// (charts grown by planarity).
/// Differs: each chart is projected, not parametrised by a solver, so nothing can fold.
Charts makeCharts(const Mesh& mesh, const ChartSettings& settings = {});

/// Whether every face is in exactly one chart, the one given by chartOfFace.
bool coversFacesOnce(const Charts& charts, std::size_t faceCount);

} // namespace osgPMObjects::core
