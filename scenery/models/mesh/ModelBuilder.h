// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// A corner of a face.
struct Corner
{
    glm::dvec3 at{0.0};
    glm::vec2 uv{0.0F};
    glm::vec3 normal{0.0F}; ///< 0: computed from the faces around
    float light = 1.0F;     ///< share of the sky it sees; darkens the tint
};

/// Puts a model together of triangles. Places are rounded to 1/4096 m, so that what was computed by two ways meets to the last
/// bit, on every machine. Faces that use a place twice are left out: where a ring shrinks to a point.
class ModelBuilder
{
public:
    /// What follows is one part, of one surface, its colours multiplied by `tint`.
    void begin(const std::string& part, const Surface& surface, const glm::vec3& tint = glm::vec3(1.0F));
    void tint(const glm::vec3& tint) { _tint = tint; }

    /// Corners counter-clockwise seen from outside.
    void triangle(const Corner& a, const Corner& b, const Corner& c);
    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);

    /// Rows of equal length, joined by quads: outside is where row r runs to the right below row r + 1.
    void grid(const std::vector<std::vector<Corner>>& rows);

    /// Normals where none were given (edges sharper than `creaseDeg` stay sharp), equal wedges joined, measures taken.
    Model finish(double creaseDeg = 42.0);

private:
    osgPMObjects::core::MeshBuilder _mesh;
    std::vector<Surface> _surfaces;
    std::uint32_t _material = 0;
    std::uint32_t _part = 0;
    glm::vec3 _tint{1.0F};
};

} // namespace scenery::models
