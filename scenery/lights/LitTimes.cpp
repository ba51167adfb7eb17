// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/LitTimes.h"

#include <cmath>

#include <foundation/Random.h>

namespace scenery
{

namespace
{

Flash between(double fromHour, double toHour)
{
    return {kDayS, 3600.0 * std::fmod(fromHour, 24.0), 3600.0 * (toHour - fromHour)};
}

} // namespace

Flash litTimes(RoomUse use, std::uint64_t room)
{
    foundation::SplitMix64 random(room);
    const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1.0p-53; };
    const double chance = share(), early = share(), late = share();
    switch (use)
    {
    case RoomUse::dwelling:
        if (chance < 0.04) return between(17.0, 32.0);
        if (chance > 0.55) return between(0.0, 0.0);
        return between(17.0 + 3.0 * early, 20.5 + 4.5 * late);
    case RoomUse::work:
        if (chance < 0.03) return between(6.0, 30.0);
        if (chance > 0.75) return between(0.0, 0.0);
        return between(6.0 + 2.0 * early, 16.0 + 4.0 * late * late);
    case RoomUse::shop:
        return chance < 0.25 ? between(6.5, 30.5) : between(6.5 + early, 18.0 + 2.0 * late);
    default:
        return between(0.0, 0.0);
    }
}

} // namespace scenery
