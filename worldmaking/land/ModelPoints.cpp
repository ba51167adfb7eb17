// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/ModelPoints.h"

#include <string>

#include "worldmaking/land/MapFile.h"

namespace worldmaking
{

foundation::Result<std::size_t> writeModels(const LandMap& map, const MapPlane& plane, const RoadRoom& roads,
                                            const foundation::HeightInPlan& height,
                                            const std::filesystem::path& file)
{
    std::vector<const LandShape*> standing;
    for (const LandShape& shape : map.shapes)
    {
        if (shape.form != ShapeForm::point || valueOf(shape.tags, "model").empty()) continue;
        const auto place = plane.toPlan(shape.paths.front().front());
        if (place && roads.distanceM(*place, kModelRoomM) >= kModelRoomM && height(*place))
            standing.push_back(&shape);
    }
    if (standing.empty()) return std::size_t{0};
    MapFile made(file);
    made.beginLayer("objects", ShapeForm::point, {"kind", "seed", "heading"});
    for (const LandShape* shape : standing)
    {
        Tags tags = shape->tags;
        tags["kind"] = tags["model"];
        made.add(shape->paths, tags);
    }
    if (const auto written = made.finish(); !written) return written.error();
    return standing.size();
}

} // namespace worldmaking
