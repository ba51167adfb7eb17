// SPDX-License-Identifier: Apache-2.0
#include "IslandShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/common.hpp>

#include "IslandPlan.h"

namespace islandgen
{

namespace
{

// The coast, clockwise from the north-west cape. The range below follows its north and east.
constexpr std::array<PlaceKm, 19> kCoast = {{{2.2f, 20.3f},
                                             {5.5f, 22.4f},
                                             {9.3f, 21.9f},
                                             {13.2f, 22.7f},
                                             {17.2f, 20.9f},
                                             {20.6f, 18.6f},
                                             {22.4f, 14.4f},
                                             {22.8f, 9.6f},
                                             {21.4f, 6.2f},
                                             {22.0f, 3.0f},
                                             {19.6f, 1.6f},
                                             {16.9f, 3.9f},
                                             {13.8f, 5.4f},
                                             {11.2f, 4.6f},
                                             {9.0f, 2.4f},
                                             {5.4f, 1.9f},
                                             {2.6f, 4.4f},
                                             {1.9f, 9.4f},
                                             {4.6f, 14.8f}}};
constexpr std::array<PlaceKm, 6> kRange = {
    {{5.0f, 19.4f}, {9.0f, 19.0f}, {13.0f, 18.4f}, {16.4f, 16.0f}, {18.8f, 12.6f}, {19.9f, 8.6f}}};
// Metres of steepness along the range: it rises to the north-east and falls to both ends.
constexpr std::array<float, 6> kRangeSteepnessM = {90.0f, 180.0f, 320.0f, 300.0f, 210.0f, 90.0f};

struct Hill
{
    PlaceKm centre;
    float radiusKm;
    float steepnessM;
};

// The western hills, a ridge that ends in the south-eastern cape, and a lone hill in the plain.
constexpr std::array<Hill, 8> kHills = {{{{5.0f, 7.0f}, 3.0f, 30.0f},
                                         {{6.6f, 5.2f}, 2.6f, 38.0f},
                                         {{4.2f, 10.8f}, 2.6f, 24.0f},
                                         {{19.4f, 5.6f}, 2.0f, 34.0f},
                                         {{20.4f, 3.8f}, 1.8f, 26.0f},
                                         {{18.6f, 3.6f}, 1.6f, 14.0f},
                                         {{11.0f, 11.7f}, 1.3f, 15.0f},
                                         {{12.0f, 10.6f}, 1.2f, 18.0f}}};

struct Nearest
{
    float distanceKm;
    float along; ///< segment number and fraction
};

Nearest nearestOnPath(PlaceKm place, std::span<const PlaceKm> path, bool closed)
{
    Nearest nearest{1e9f, 0.0f};
    const std::size_t segments = closed ? path.size() : path.size() - 1;
    for (std::size_t i = 0; i < segments; ++i)
    {
        const PlaceKm a = path[i];
        const PlaceKm b = path[(i + 1) % path.size()];
        const float ex = b.x - a.x;
        const float ey = b.y - a.y;
        const float t =
            std::clamp(((place.x - a.x) * ex + (place.y - a.y) * ey) / (ex * ex + ey * ey), 0.0f, 1.0f);
        const float dx = place.x - a.x - t * ex;
        const float dy = place.y - a.y - t * ey;
        const float distance = std::sqrt(dx * dx + dy * dy);
        if (distance < nearest.distanceKm) nearest = {distance, static_cast<float>(i) + t};
    }
    return nearest;
}

bool insideCoast(PlaceKm place)
{
    bool inside = false;
    for (std::size_t i = 0, j = kCoast.size() - 1; i < kCoast.size(); j = i++)
    {
        const PlaceKm a = kCoast[i];
        const PlaceKm b = kCoast[j];
        if ((a.y > place.y) == (b.y > place.y)) continue;
        if (place.x < (b.x - a.x) * (place.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

/// 1 in the middle, 0 from `radiusKm` outwards.
float hill(PlaceKm place, PlaceKm centre, float radiusKm)
{
    const float dx = place.x - centre.x;
    const float dy = place.y - centre.y;
    return 1.0f - glm::smoothstep(0.15f, 1.0f, std::sqrt(dx * dx + dy * dy) / radiusKm);
}

/// Steepness of the main range: a steep, short outer flank and a longer one towards the plain.
float rangeSteepnessM(PlaceKm place, Noise noise)
{
    const PlaceKm moved = warped(place, noise.channel(20), 5.0f, 1.3f, 4);
    const Nearest nearest = nearestOnPath(moved, kRange, false);
    const auto segment = std::min(static_cast<std::size_t>(nearest.along), kRange.size() - 2);
    const float fraction = nearest.along - static_cast<float>(segment);
    const float crestM =
        kRangeSteepnessM[segment] + fraction * (kRangeSteepnessM[segment + 1] - kRangeSteepnessM[segment]);
    const float variation = 1.0f + 0.35f * noise.channel(21).fractal(place.x / 3.0f, place.y / 3.0f, 3);
    return crestM * variation * (1.0f - glm::smoothstep(0.0f, 5.0f, nearest.distanceKm));
}

} // namespace

PlaceKm warped(PlaceKm place, Noise noise, float wavelengthKm, float amplitudeKm, int octaves)
{
    const float x = place.x / wavelengthKm;
    const float y = place.y / wavelengthKm;
    return {place.x + amplitudeKm * noise.channel(1).fractal(x, y, octaves),
            place.y + amplitudeKm * noise.channel(2).fractal(x, y, octaves)};
}

float plannedInlandKm(PlaceKm place, Noise noise)
{
    const PlaceKm moved = warped(place, noise.channel(10), 4.5f, 1.1f, 5);
    const float distance = nearestOnPath(moved, kCoast, true).distanceKm;
    const float frameKm =
        std::min(std::min(place.x, place.y), std::min(kExtentKm - place.x, kExtentKm - place.y)) - 0.9f;
    return std::min(insideCoast(moved) ? distance : -distance, frameKm);
}

float steepnessM(PlaceKm place, Noise noise)
{
    const PlaceKm moved = warped(place, noise.channel(30), 2.8f, 0.9f, 4);
    const float range = rangeSteepnessM(place, noise);
    float hills = 0.0f;
    for (const Hill& h : kHills)
        hills = std::max(hills, h.steepnessM * hill(moved, h.centre, h.radiusKm));
    const float patches =
        std::max(noise.channel(32).fractal(place.x / 2.6f, place.y / 2.6f, 3) + 0.25f, 0.0f);
    const float foothills =
        30.0f * patches *
        (1.0f - glm::smoothstep(3.0f, 6.8f, nearestOnPath(moved, kRange, false).distanceKm));
    const float plain = 3.2f + 1.6f * noise.channel(31).fractal(place.x / 3.5f, place.y / 3.5f, 3);
    return std::max(range, 0.0f) + foothills + hills + std::max(plain, 1.2f);
}

} // namespace islandgen
