// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace worldmaking
{

/// Reads a value of `maxspeed`, km/h: a number with its unit, `walk`, `none` (the 130 that is advised), or
/// the limit that a country has for a kind of road: `DE:urban`, `GB:nsl_single`, `DE:zone:30`. Nothing where
/// it names no speed (`signals`, `variable`), or none of 3 to 200 km/h.
/// Source: the OpenStreetMap wiki, *Key:maxspeed* and *Default speed limits*, 2024; a country that is not
/// listed has the most usual limits.
std::optional<double> speedKmhOf(std::string_view text);

} // namespace worldmaking
