// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Writes the points of a map that name a generated model (key `model`, and `heading` in degrees from north,
/// clockwise, and `seed`) as objects of a world, but those nearer than kModelRoomM to lanes or beyond the
/// ground. Returns how many there are; no file where there is none.
/// Errors: as MapFile::finish().
foundation::Result<std::size_t> writeModels(const LandMap& map, const MapPlane& plane, const RoadRoom& roads,
                                            const foundation::HeightInPlan& height,
                                            const std::filesystem::path& file);

inline constexpr double kModelRoomM = 1.2;

} // namespace worldmaking
