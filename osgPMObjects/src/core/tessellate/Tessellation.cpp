// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgPMObjects/core/tessellate/Tessellation.h>

namespace osgPMObjects::core
{

foundation::Result<Tessellation> tessellate(std::span<const glm::dvec3> corners,
                                            std::span<const std::uint32_t> contourSizes,
                                            const OutlineOptions& options)
{
    auto outline = outlinePolygon(corners, contourSizes, options);
    if (!outline) return outline.error();
    Tessellation result;
    for (const Loop& loop : outline->loops)
    {
        const auto triangles = clipEars(outline->points, loop);
        if (!triangles)
            return foundation::Error{"polygon", "an outline could not be cut into triangles",
                                     "report it together with the polygon: this is a defect of the program"};
        result.triangles.insert(result.triangles.end(), triangles->begin(), triangles->end());
    }
    result.inserted = std::move(outline->inserted);
    result.crossings = outline->crossings;
    result.unusedCorners = outline->unusedCorners;
    result.bridges = outline->bridges;
    return result;
}

} // namespace osgPMObjects::core
