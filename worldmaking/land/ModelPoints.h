// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Returns a direction in degrees from north, clockwise, as the key `heading` has it.
std::string bearingOf(const glm::dvec2& direction);

/// Tells whether a shape is a point that names a generated model.
inline bool namesModel(const LandShape& shape)
{
    return shape.form == ShapeForm::point && !valueOf(shape.tags, "model").empty();
}

/// Writes the points of a map that name a generated model (key `model`, and `heading` in degrees from north,
/// clockwise, and `seed`) as objects of a world, but those nearer than kModelRoomM to lanes or beyond the
/// ground. Returns how many there are; no file where there is none.
/// Errors: as MapFile::finish().
foundation::Result<std::size_t> writeModels(std::span<const LandShape> shapes, const MapPlane& plane,
                                            const RoadRoom& roads, const foundation::HeightInPlan& height,
                                            const std::filesystem::path& file);

inline constexpr double kModelRoomM = 1.2;

} // namespace worldmaking
