// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/MapPlane.h"

#include <cstdio>

#include <glm/glm.hpp>

namespace worldmaking
{

osgRoads::core::NetworkHeader planeAbout(const LandMap& map)
{
    glm::dvec2 low(180.0, 90.0), high(-180.0, -90.0);
    for (const LandShape& shape : map.shapes)
        if (!shape.paths.empty() && !shape.paths.front().empty())
        {
            low = glm::min(low, shape.paths.front().front());
            high = glm::max(high, shape.paths.front().front());
        }
    const glm::dvec2 middle = low.x <= high.x ? 0.5 * (low + high) : glm::dvec2(0.0);
    char text[160];
    std::snprintf(text, sizeof text,
                  "+proj=tmerc +lat_0=%.6f +lon_0=%.6f +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
                  middle.y, middle.x);
    osgRoads::core::NetworkHeader header;
    header.geoReference = text;
    return header;
}

} // namespace worldmaking
