// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// A point of the full surface that corresponds to a point of a simplified one.
struct MatchedPoint
{
    std::uint32_t face = 0;
    glm::dvec3 weights{1.0, 0.0, 0.0}; ///< barycentric; their sum is 1
    bool agrees = false;               ///< found within reach, with the wanted orientation and part
};

/// Finds the points of a full surface that correspond to points of a simplified one. A candidate face must be
/// of the same part, or of a part without simplified faces; blended if the simplified face is; and of the
/// same orientation, so that thin walls do not show their other side. The result is the first candidate
/// within reach along the normal, to either side, unless another candidate is three times nearer. Without
/// candidates it is the nearest point of the part in any orientation, or the nearest of all.
/// Threads: queries from any number at once. Cost: some microseconds a query.
/// Source: Cignoni, Montani, Rocchini and Scopigno, *A general method for preserving attribute values on
/// simplified meshes* (1998), section 3 (nearest point). Differs: we look along the normal first, which does
/// not smear the flanks of protrusions.
class SurfaceMatch
{
public:
    /// `simplified`: made of `full`, with the same numbers of parts and materials. `reach` of 0: 1.5 times
    /// the distance of the simplified surface's corners and face centres from the full one.
    SurfaceMatch(const Mesh& full, const Mesh& simplified, double reach);

    /// `normal`: unit length; the orientation of the simplified surface at the point.
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
