// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>

namespace osgPMObjects::core
{

/// The faces and positions of a mesh at one time, to find later what has changed.
class MeshSnapshot
{
public:
    explicit MeshSnapshot(const Mesh& mesh);

    /// Returns all positions of faces around changes, sorted: around positions that moved, and faces that
    /// were replaced. Elsewhere no face, no edge and no number of faces on an edge has changed. `origins`: by
    /// face, the number of the face that it was or comes from, rising; empty: none has changed its number.
    std::vector<std::uint32_t> changedSince(const Mesh& mesh,
                                            std::span<const std::uint32_t> origins = {}) const;

private:
    std::vector<std::uint8_t> marksOfOtherFaces(const Mesh& mesh,
                                                std::span<const std::uint32_t> origins) const;

    std::vector<glm::dvec3> _positions;
    std::vector<Triangle> _triangles;
};

/// Tracks the origins of faces while they are removed and cut: from construction until giveBack() their parts
/// are their numbers. Pieces must keep the part of their face, and the order.
class FaceOrigins
{
public:
    explicit FaceOrigins(Mesh& mesh);

    /// Restores the parts of the faces, and returns for each the number of the face it comes from.
    std::vector<std::uint32_t> giveBack(Mesh& mesh) const;

private:
    std::vector<std::uint32_t> _parts; ///< by face
};

} // namespace osgPMObjects::core
