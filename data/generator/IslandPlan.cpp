// SPDX-License-Identifier: Apache-2.0
#include "IslandPlan.h"

#include <glm/common.hpp>

#include "IslandShape.h"
#include "Resample.h"

namespace islandgen
{

IslandPlan makeIslandPlan(int side, Noise noise)
{
    IslandPlan plan(side);
    const float cellKm = kExtentKm / static_cast<float>(side - 1);
    for (int row = 0; row < side; ++row)
    {
        for (int column = 0; column < side; ++column)
        {
            const PlaceKm place{static_cast<float>(column) * cellKm, static_cast<float>(row) * cellKm};
            const int cell = plan.inlandKm.index(column, row);
            plan.inlandKm[cell] = plannedInlandKm(place, noise);
            plan.steepnessM[cell] = steepnessM(place, noise);
            const float rugged = glm::smoothstep(4.0f, 18.0f, plan.steepnessM[cell]);
            const PlaceKm bent = warped(place, noise.channel(40), 3.0f, 0.8f, 3);
            // Beds of harder and softer rock, dipping south-west: bands across the range's grain.
            const float bed = noise.channel(41).fractal(bent.x * 0.9f + bent.y * 0.5f, bent.y * 0.12f, 3);
            plan.erodibility[cell] = std::clamp(1.0f + 0.55f * bed, 0.45f, 1.9f);
            plan.diffuseKm[cell] = 0.060f + (0.025f - 0.060f) * rugged;
            plan.criticalSlope[cell] =
                std::clamp(1.12f - 0.30f * bed, 0.8f, 1.5f) *
                (0.58f + 0.42f * glm::smoothstep(40.0f, 190.0f, plan.steepnessM[cell]));
            plan.shelfM[cell] = -10.0f - 35.0f * glm::smoothstep(0.0f, 6.0f, place.y - 24.0f + place.x);
        }
    }
    return plan;
}

IslandPlan resampled(const IslandPlan& plan, int side)
{
    IslandPlan result(side);
    result.inlandKm = resampled(plan.inlandKm, side);
    result.steepnessM = resampled(plan.steepnessM, side);
    result.erodibility = resampled(plan.erodibility, side);
    result.diffuseKm = resampled(plan.diffuseKm, side);
    result.criticalSlope = resampled(plan.criticalSlope, side);
    result.shelfM = resampled(plan.shelfM, side);
    return result;
}

} // namespace islandgen
