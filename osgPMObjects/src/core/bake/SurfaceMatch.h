// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// The point of the full surface that a point of a simplified one stands for.
struct MatchedPoint
{
    std::uint32_t face = 0;
    glm::dvec3 weights{1.0, 0.0, 0.0}; ///< of its corners; they add up to 1
    bool agrees =
        false; ///< it faces the way that was asked for, within reach, on the part that was asked for
};

/// Finds for points of a simplified surface those of the full one that they stand for. Faces that count are of the same part as the
/// simplified face, or of a part of which the simplified mesh shows nothing, and blended if it is; they face the same way, so that a thin
/// wall does not show its other side. Among these the first one along the normal, to either side, within reach, unless
/// another is three times nearer. Where none counts: the nearest of the part whichever way it faces, or the nearest at all.
/// Threads: questions from any number at once. Cost: some microseconds a question.
/// Source: Cignoni, Montani, Rocchini and Scopigno, "A general method for preserving attribute values on simplified meshes" (1998),
/// §3 (nearest point); we look along the normal first, which does not smear the flanks of what stands out.
class SurfaceMatch
{
public:
    /// `simplified`: made of `full`, its parts and materials have the same numbers. `reach` of 0: found out, half as much again as
    /// the simplified surface's corners and centres are away from the full one.
    SurfaceMatch(const Mesh& full, const Mesh& simplified, double reach);

    /// `normal`: unit length; the way the surface faces at the point.
    MatchedPoint find(const glm::dvec3& point, const glm::dvec3& normal, const Face& simplifiedFace) const;

    double reach() const { return _reach; }
    const glm::dvec3& faceNormal(std::uint32_t fullFace) const { return _normals[fullFace]; }

private:
    bool isCounterpart(const Face& full, const Face& simplified) const;
    MatchedPoint matchedPoint(const TrianglePoint& found, bool agrees) const;

    const Mesh& _full;
    std::vector<Triangle> _triangles;
    TriangleTree _tree;
    std::vector<glm::dvec3> _normals; ///< by full face, unit length; 0 without area
    std::vector<bool> _isGone;        ///< by part
    double _reach;
};

} // namespace osgPMObjects::core
