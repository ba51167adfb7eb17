// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact/Impact.h"

#include <cstdio>

namespace simulation
{

std::string textOf(const Impact& impact, double startS)
{
    constexpr double kKmhPerMps = 3.6;
    const std::string kind(factsOf(impact.kind).name);
    const std::string what =
        impact.name.empty() || impact.name == kind ? kind : kind + " (" + impact.name + ")";
    const bool isOneOfMany = impact.kind != ObstacleKind::ground && impact.kind != ObstacleKind::water;
    char begun[80], place[80];
    std::snprintf(begun, sizeof begun, "after %.2f s at %.0f km/h into %s ", startS + impact.timeS,
                  kKmhPerMps * impact.speedMps, isOneOfMany ? "a" : "the");
    std::snprintf(place, sizeof place, " at %.1f, %.1f", impact.place.x, impact.place.y);
    return begun + what + place + (impact.damage.empty() ? "" : ": " + impact.damage);
}

} // namespace simulation
