// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

/// Builds a mesh from what importers read. Positions that are equal to the last bit become one; wedges stay
/// as in the file.
class MeshBuilder
{
public:
    MeshBuilder() : _positions(0) {}

    /// Returns the number of a position and adds it when it is new. It must be finite.
    std::uint32_t position(const glm::dvec3& where);
    std::uint32_t wedge(const Wedge& wedge) { return appendWedge(_mesh, wedge); }
    void face(const Face& face) { _mesh.faces.push_back(face); }
    std::uint32_t material(const Material& material);
    std::uint32_t part(const std::string& name);

    const Mesh& mesh() const { return _mesh; }
    Mesh finish() { return std::move(_mesh); }

private:
    Mesh _mesh;
    HashIndex _positions;
};

} // namespace osgPMObjects::core
