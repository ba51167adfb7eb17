// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// The weights that turn differences of attributes into distances: a difference of 1 (LevelError) counts as much as this
/// distance, in the model's units; 0 ignores the attribute. For texture coordinates use the width of the texture on the
/// surface: the error is then the distance by which the texture drifts.
struct AttributeWeights
{
    float normal = 0.0f, texCoord = 0.0f, colour = 0.0f;
};

/// Returns the largest of a level's errors, as a distance in the model's units. It never falls from level to level.
inline float errorOf(const LevelError& error, const AttributeWeights& weights)
{
    float most = error.distance;
    for (const float attribute :
         {weights.normal * error.normal, weights.texCoord * error.texCoord, weights.colour * error.colour})
        most = attribute > most ? attribute : most;
    return most;
}

/// Returns the coarsest level whose error is at most `tolerance`; level 0 if there is none. Cost: log n.
/// `errors`: by level, as in LevelTable. Units of the tolerance: the model's positions.
std::uint32_t coarsestWithin(std::span<const LevelError> errors, double tolerance,
                             const AttributeWeights& weights = {});

/// Returns the same with hysteresis. The held level stays while its error is at most `tolerance` and the error of the next
/// coarser level is more than `tolerance` / `band`²; else the result is the coarsest level within `tolerance` / `band`. So
/// the tolerance always holds, and the band costs some detail. `band` ≥ 1: a factor of distance, see kDefaultBand. Cost: two
/// look-ups while the level stays, else log n.
/// Source: the authors; viewlod/ScreenError.h has the bound in pixels.
std::uint32_t heldWithin(std::span<const LevelError> errors, double tolerance, double band, HeldLevel held,
                         const AttributeWeights& weights = {});

/// Returns the error, in the model's units, that covers `tolerancePx` pixels at any point of the image; so turning the
/// camera about its eye changes no level. It is the inverse of viewlod::screenErrorBoundPx(). `depthM`: from the eye to the
/// nearest point of the bounding sphere, at least the near distance.
double tolerableError(double tolerancePx, double pixelsPerTangent, double depthM, double metresPerUnit);

} // namespace osgPMObjects::core
