// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

enum class ShapeForm : std::uint8_t
{
    point,
    line,
    area,
};

/// A thing of a map: a point, a line, or an area with its holes. Units: degrees east and north (WGS84).
struct LandShape
{
    std::int64_t id = 0; ///< of the map where it has ids, else the number in its layer
    ShapeForm form = ShapeForm::point;
    std::vector<std::vector<glm::dvec2>>
        paths; ///< one of one point; one line; the outline, then holes, closed without repeats
    Tags tags;
};

/// What a map has besides streets, and its streets as lines, as plain values.
struct LandMap
{
    std::vector<LandShape> shapes;    ///< in the order of the source
    std::size_t unusable = 0;         ///< without geometry, or with too few points
    std::vector<std::string> notes{}; ///< what GDAL warned of, one line each
};

/// A rectangle of the map. Units: degrees.
struct MapBounds
{
    double west = -180.0, south = -90.0, east = 180.0, north = 90.0;

    bool contains(const glm::dvec2& place) const
    {
        return place.x >= west && place.x <= east && place.y >= south && place.y <= north;
    }
};

} // namespace worldmaking
