// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace pmtool
{

/// Triangles that are drawn by one call, with vertices numbered from 0 as they are first used.
struct DrawCall
{
    std::vector<osgPMObjects::core::Triangle> triangles;
    std::vector<glm::dvec3> positions; ///< by vertex
};

/// A model with its vertices counted in one of two ways.
struct OrderSubject
{
    /// "positions": one for each position, all of the model in one call. "wedges": as it is drawn, one for
    /// each position with its attributes, needless splits merged, a call for each material.
    std::string vertices;
    std::vector<DrawCall> calls;

    std::size_t triangleCount() const;
    std::size_t vertexCount() const;
};

/// Both ways of a model.
std::array<OrderSubject, 2> orderSubjects(osgPMObjects::core::Mesh mesh);

} // namespace pmtool
