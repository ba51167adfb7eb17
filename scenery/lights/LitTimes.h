// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/lights/LightPoint.h"
#include "scenery/lights/RoomUse.h"

namespace scenery
{

inline constexpr double kDayS = 86400.0;

/// Returns when a room is lit, as a flash with the period of a day from midnight on, by local solar time;
/// never lit: litS 0. Half the rooms of dwellings are lit for a while between 17 and 1 o'clock, a few all
/// night; rooms of work from 6 to 8 until 16 to 20 o'clock; shops until 18 to 20 o'clock, a quarter of their
/// windows all night. The same number, the same times.
Flash litTimes(RoomUse use, std::uint64_t room);

} // namespace scenery
