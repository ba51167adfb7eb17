// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace pmtool
{

/// One polygon of a file: contours of vertices, one after the other.
struct Polygon
{
    std::vector<std::uint32_t> corners; ///< numbers of vertices in PolygonSet
    std::vector<std::uint32_t> contourSizes;
    bool isTextured = false;
    std::string location; ///< where it stands in the file, for messages: "line 12", "features[3]"
};

/// All polygons of a file. A vertex is a position with a texture coordinate.
/// Invariant: coordinates are finite, corners are below the number of positions, each contour has at least 3
/// corners.
struct PolygonSet
{
    std::vector<glm::dvec3> positions; ///< by vertex; frame and units of the file
    std::vector<glm::dvec2> texCoords; ///< by vertex, or empty: no polygon is textured
    std::vector<Polygon> polygons;
};

} // namespace pmtool
