// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Joins the meshes of the parts of a network, which have one origin, in the order in which they are added.
/// Memory: after the first part room for all is reserved, as large as parts have been so far; pages of it
/// that nothing is written to cost none.
class MeshJoiner
{
public:
    /// `parts`: how many will be added.
    MeshJoiner(const glm::dvec3& origin, std::size_t parts);

    const glm::dvec3& origin() const { return _mesh.origin; }
    void add(RoadMesh part);
    RoadMesh take() { return std::move(_mesh); }

private:
    void makeRoomFor(const RoadMesh& part);

    RoadMesh _mesh;
    std::size_t _parts, _added = 0;
};

} // namespace osgRoads::core
