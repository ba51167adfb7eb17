// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

/// Puts a mesh together from what importers read: positions that are equal to the last bit become one, wedges stay as many
/// as the file has.
class MeshBuilder
{
public:
    MeshBuilder() : _positions(0) {}

    /// The number of the position, new or known. It has to be finite.
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
