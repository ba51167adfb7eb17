// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/selection/HeldLevel.h>

namespace osgPMObjects::core
{

/// The answer of the continuous rule: how many positions to remove, one by each step.
struct Removal
{
    std::uint32_t steps = 0;
    bool isClamped = false; ///< true if the rule asks for more steps than there are

    bool operator==(const Removal&) const = default;
};

/// Computes the distance z1 at which an edge of a mean face, √(2·S/F) long, is `trianglePx` pixels long:
///     z1 = K·√(2·S/F) / trianglePx.
/// A triangle then covers one to two pixels. K: `pixelsPerTangent`; S: `area` in metres squared; F: `faces`,
/// 0 gives 0.
/// Units: metres.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), introduction (one to two pixels) and section 5, formulas 3 and 4. Differs: the factor
/// `trianglePx`.
double referenceDistanceM(double pixelsPerTangent, double area, std::uint32_t faces, double trianglePx = 1.5);

/// Computes how many positions to remove so that edges keep the projected length that they have at z1:
///     T = (V - 2)·(1 - (z1/z2)²)
/// to the nearest whole number; 0 for z2 ≤ z1 or fewer than three positions; at most `mostSteps`.
/// `positions`: V, of the mesh drawn at z1. `referenceM`: z1 > 0. `distanceM`: z2, from the eye to the centre
/// of the bounding sphere. Valid for objects that are small compared with their distance.
/// Source: Sadykov & Zakharov (2002), section 5, after formula 7.
Removal removalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps);

/// Computes the same with hysteresis: the held level stays while it lies between T at the distance and T at
/// the distance divided by `band`²; else it becomes T at the distance divided by `band`. `band` 1 gives
/// removalAt() itself.
Removal heldRemovalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps,
                      double band, HeldLevel held);

} // namespace osgPMObjects::core
