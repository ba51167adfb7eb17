// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>

#include "UniteConvex.h"

namespace osgPMObjects::core
{

namespace
{

/// Tells whether a loop has a bridge: an edge run through in both directions.
bool hasBridge(const Loop& loop)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < loop.size(); ++i)
        edges.push_back(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    std::sort(edges.begin(), edges.end());
    return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

} // namespace

foundation::Result<ConvexDecomposition> decomposeConvex(std::span<const glm::dvec3> corners,
                                                        std::span<const std::uint32_t> contourSizes,
                                                        ConvexMethod method, const OutlineOptions& options)
{
    auto outline = outlinePolygon(corners, contourSizes, options);
    if (!outline) return outline.error();
    ConvexDecomposition result;
    for (const Loop& loop : outline->loops)
    {
        std::optional<std::vector<Loop>> pieces;
        if (method == ConvexMethod::leastPieces) pieces = leastConvexPieces(outline->points, loop);
        result.isLeast = result.isLeast && pieces && !hasBridge(loop);
        if (pieces)
            pieces = uniteConvexPieces(outline->points, *pieces); // across bridges
        else if (const auto triangles = clipEars(outline->points, loop))
            pieces = uniteConvex(outline->points, *triangles);
        else
            return foundation::Error{"polygon", "an outline could not be cut into triangles",
                                     "report it together with the polygon: this is a defect of the program"};
        result.pieces.insert(result.pieces.end(), pieces->begin(), pieces->end());
    }
    result.inserted = std::move(outline->inserted);
    return result;
}

} // namespace osgPMObjects::core
