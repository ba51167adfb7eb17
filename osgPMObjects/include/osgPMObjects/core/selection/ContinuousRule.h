// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/selection/HeldLevel.h>

namespace osgPMObjects::core
{

/// How many positions to remove, each by one step.
struct Removal
{
    std::uint32_t steps = 0;
    bool isClamped = false; ///< whether the rule asked for more than can be removed

    bool operator==(const Removal&) const = default;
};

/// The distance z1 at which an edge of a mean face, √(2·S/F) long, is `trianglePx` pixels long, so that a triangle covers one
/// to two pixels: K·√(2·S/F) / trianglePx. `area` in metres squared; 0 without faces. Units: metres.
/// Source: paper 004, section 5, formulas 3 and 4; introduction, for the one to two pixels. The factor is ours.
double referenceDistanceM(double pixelsPerTangent, double area, std::uint32_t faces, double trianglePx = 1.5);

/// T = (V - 2)·(1 - (z1/z2)²), to the nearest whole number; 0 for z2 ≤ z1 and fewer than three positions; never more than
/// `mostSteps`. So the projected length of edges stays what it is at z1.
/// `positions`: V, those of the mesh drawn at z1. `referenceM`: z1 > 0. `distanceM`: z2, of the eye from the centre of the
/// bounding sphere. Valid for objects small against the scene.
/// Source: paper 004, section 5, after formula 7.
Removal removalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps);

/// The same with hysteresis: what was held stays while it lies between T at the distance and T at the distance over
/// `band`²; else T at the distance over `band`. With `band` 1 it is removalAt() itself.
Removal heldRemovalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps,
                      double band, HeldLevel held);

} // namespace osgPMObjects::core
