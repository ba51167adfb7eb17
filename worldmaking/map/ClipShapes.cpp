// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ClipShapes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPieces.h"
#include "worldmaking/map/OgrPolygon.h"

namespace worldmaking
{
namespace
{

using Path = std::vector<glm::dvec2>;

bool reachesBeyond(const LandShape& shape, const MapBounds& bounds)
{
    return std::any_of(shape.paths.begin(), shape.paths.end(),
                       [&](const Path& path)
                       {
                           return !std::all_of(path.begin(), path.end(),
                                               [&](const glm::dvec2& place)
                                               { return bounds.contains(place); });
                       });
}

} // namespace

std::size_t clipTo(const MapBounds& bounds, double marginDeg, LandMap& map)
{
    const GdalScope quiet;
    const MapBounds wide{bounds.west - marginDeg, bounds.south - marginDeg, bounds.east + marginDeg,
                         bounds.north + marginDeg};
    const auto box = polygonOf({{{wide.west, wide.south},
                                 {wide.east, wide.south},
                                 {wide.east, wide.north},
                                 {wide.west, wide.north}}});
    std::vector<LandShape> kept;
    kept.reserve(map.shapes.size());
    std::size_t cut = 0;
    for (LandShape& shape : map.shapes)
    {
        if (!reachesBeyond(shape, wide))
        {
            kept.push_back(std::move(shape));
            continue;
        }
        ++cut;
        if (shape.form == ShapeForm::point) continue;
        const auto whole = geometryOf(shape);
        const std::unique_ptr<OGRGeometry> inside(whole ? whole->Intersection(box.get()) : nullptr);
        if (inside) addPieces(*inside, shape, kept);
    }
    map.shapes = std::move(kept);
    return cut;
}

} // namespace worldmaking
