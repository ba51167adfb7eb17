// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
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

/// Builds a model of triangles. Positions are rounded to 1/4096 m, so that positions computed in two ways
/// agree to the last bit on every machine. Faces with two equal positions are left out, as where a ring
/// shrinks to a point.
class ModelBuilder
{
public:
    /// Begins a part of one surface, whose colours are multiplied by `tint`.
    void begin(const std::string& part, const Surface& surface, const glm::vec3& tint = glm::vec3(1.0F));
    void tint(const glm::vec3& tint) { _tint = tint; }

    /// From here on corners are turned by `turn`, then moved by `shift`.
    void place(const glm::dmat3& turn, const glm::dvec3& shift)
    {
        _turn = turn;
        _shift = shift;
    }

    /// Adds a triangle or quad, corners counter-clockwise seen from outside.
    void triangle(const Corner& a, const Corner& b, const Corner& c);
    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);

    /// Adds rows of equal length joined by quads. Outside is the side from which row r runs to the right
    /// below row r + 1.
    void grid(const std::vector<std::vector<Corner>>& rows);

    /// Finishes the model: computes missing normals (edges sharper than `creaseDeg` stay sharp), joins equal
    /// wedges, measures the size.
    Model finish(double creaseDeg = 42.0);

private:
    osgPMObjects::core::MeshBuilder _mesh;
    std::vector<Surface> _surfaces;
    std::uint32_t _material = 0;
    std::uint32_t _part = 0;
    glm::vec3 _tint{1.0F};
    glm::dmat3 _turn{1.0};
    glm::dvec3 _shift{0.0};
};

} // namespace scenery::models
