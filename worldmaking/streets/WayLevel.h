// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// What lies on a piece of a street.
enum class StreetPlace : std::uint8_t
{
    ground,
    bridge,
    tunnel,
};

/// How high a way lies among those that it crosses.
struct WayLevel
{
    StreetPlace place = StreetPlace::ground;
    int layer = 0;

    friend bool operator==(const WayLevel&, const WayLevel&) = default;
};

/// Returns the level of a way by its tags `bridge`, `tunnel` and `layer`. Without a layer a bridge has 1 and
/// a tunnel -1. A passage through a house, a gallery and a covered way lie on the ground.
/// Source: the OpenStreetMap wiki, *Key:layer*, *Key:tunnel*, *Key:covered*.
WayLevel levelOf(const Tags& tags);

/// Tells which of two ways that cross passes over the other: 1 the first, -1 the second, 0: the map does not
/// say. The layer decides; in one layer a bridge is above the ground, and that above a tunnel.
int aboveOf(const WayLevel& a, const WayLevel& b);

} // namespace worldmaking
