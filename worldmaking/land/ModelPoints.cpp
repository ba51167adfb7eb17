// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/ModelPoints.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "worldmaking/land/MapFile.h"

namespace worldmaking
{

std::string bearingOf(const glm::dvec2& direction)
{
    const double bearing = std::atan2(direction.x, direction.y) * 180.0 / std::numbers::pi;
    return std::to_string((std::lround(bearing) + 360) % 360);
}

foundation::Result<std::size_t> writeModels(std::span<const LandShape> shapes, const MapPlane& plane,
                                            const RoadRoom& roads, const foundation::HeightInPlan& height,
                                            const std::filesystem::path& file)
{
    std::vector<const LandShape*> standing;
    for (const LandShape& shape : shapes)
    {
        if (!namesModel(shape)) continue;
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
