// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>

namespace osgPMObjects::core
{

/// Where faces and positions were, to tell later where a mesh has changed.
class MeshSnapshot
{
public:
    explicit MeshSnapshot(const Mesh& mesh);

    /// All positions of faces around those that moved or whose faces are others now, in order: elsewhere no face, no edge and no
    /// count of faces on an edge has changed. `origins`: by face, the number of the face that it was or comes of, in order;
    /// empty: each is what it was.
    std::vector<std::uint32_t> changedSince(const Mesh& mesh,
                                            std::span<const std::uint32_t> origins = {}) const;

private:
    std::vector<std::uint8_t> marksOfOtherFaces(const Mesh& mesh,
                                                std::span<const std::uint32_t> origins) const;

    std::vector<glm::dvec3> _positions;
    std::vector<Triangle> _triangles;
};

/// Lets faces say what they come of, however they are removed and cut, as long as pieces have their part and stand in order:
/// from its making until giveBack() their parts are their numbers.
class FaceOrigins
{
public:
    explicit FaceOrigins(Mesh& mesh);

    /// Gives the faces their parts back, and returns the number of the face that each comes of.
    std::vector<std::uint32_t> giveBack(Mesh& mesh) const;

private:
    std::vector<std::uint32_t> _parts; ///< by face
};

} // namespace osgPMObjects::core
