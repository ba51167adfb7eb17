// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include "simulation/environment/CloudLayer.h"
#include "simulation/scenario/Environment.h"

namespace simulation
{

/// What a report of an aerodrome's weather tells of the sky and the air.
struct Metar
{
    Weather weather; ///< wind, visibility below 10 km, rain or snow, temperature, pressure at the sea
    std::vector<CloudLayer> clouds; ///< three at most, the lowest
};

/// Reads a METAR, with or without that word and the station before it; trends and remarks behind it count for
/// nothing. Few, scattered, broken and overcast are 2, 4, 6 and 8 oktas; the kind follows from cover and
/// height: cirrus from 6 km, heaps up to half a cover, rolls up to seven eighths, sheets beyond; tops by the
/// kind, of CB and TCU by 6 and 3 km. Vertical visibility is a cover at its height. Wind blows in the frame
/// of the scene, east and north.
/// Errors: a text without a single group that is known. `place`: for messages.
/// Source: WMO, *Manual on Codes* (WMO-No. 306), FM 15.
foundation::Result<Metar> readMetar(std::string_view text, std::string_view place);

} // namespace simulation
