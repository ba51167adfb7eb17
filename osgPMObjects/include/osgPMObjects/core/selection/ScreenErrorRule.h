// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// What differences of attributes count: a difference of 1 (LevelError) as much as so many units of distance. 0: not at all.
/// For texture coordinates it is the width of the texture on the surface, for then the drift is one of what is seen there.
struct AttributeWeights
{
    float normal = 0.0f, texCoord = 0.0f, colour = 0.0f;
};

/// The largest of a level's errors as a distance. It never falls from one level to the next.
/// Units: the model's positions.
inline float errorOf(const LevelError& error, const AttributeWeights& weights)
{
    float most = error.distance;
    for (const float attribute :
         {weights.normal * error.normal, weights.texCoord * error.texCoord, weights.colour * error.colour})
        most = attribute > most ? attribute : most;
    return most;
}

/// The coarsest level whose error is at most `tolerance`; level 0 where none is. Cost: log n.
/// `errors`: by level, as LevelTable has them. Units of the tolerance: the model's positions.
std::uint32_t coarsestWithin(std::span<const LevelError> errors, double tolerance,
                             const AttributeWeights& weights = {});

/// The same with hysteresis: the held level stays while its error is at most `tolerance` and the next level's is more than
/// `tolerance` / `band`²; else the coarsest within `tolerance` / `band`. So the tolerance holds always, and the band costs
/// detail. `band` ≥ 1; the tolerance goes with the distance, so as kDefaultBand. Cost: two look-ups while the level stays,
/// log n else.
/// Source: ours; the bound in pixels is viewlod/ScreenError.h.
std::uint32_t heldWithin(std::span<const LevelError> errors, double tolerance, double band, HeldLevel held,
                         const AttributeWeights& weights = {});

/// The error of the model, in its own units, that is `tolerancePx` pixels in the picture, anywhere in it: the turning of
/// the camera about its eye changes no level. The inverse of viewlod::screenErrorBoundPx(). `depthM`: from the eye to the
/// nearest point of the bounding sphere, or the near distance where that is more.
double tolerableError(double tolerancePx, double pixelsPerTangent, double depthM, double metresPerUnit);

} // namespace osgPMObjects::core
