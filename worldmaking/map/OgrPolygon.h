// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <ogr_geometry.h>

namespace worldmaking
{

/// Makes a polygon of GDAL's from an outline and holes, which need not be closed.
inline std::unique_ptr<OGRPolygon> polygonOf(const std::vector<std::vector<glm::dvec2>>& rings)
{
    auto polygon = std::make_unique<OGRPolygon>();
    for (const auto& ring : rings)
    {
        auto line = std::make_unique<OGRLinearRing>();
        for (const glm::dvec2& corner : ring)
            line->addPoint(corner.x, corner.y);
        line->closeRings();
        polygon->addRingDirectly(line.release());
    }
    return polygon;
}

} // namespace worldmaking
