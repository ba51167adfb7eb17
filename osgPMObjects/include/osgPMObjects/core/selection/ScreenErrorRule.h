// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// The weights that turn differences of attributes into distances: a difference of 1 (LevelError) counts as
/// much as this distance, in the model's units; 0 ignores the attribute. For texture coordinates use the
/// width of the texture on the surface: the error is then the distance by which the texture drifts.
struct AttributeWeights
{
    float normal = 0.0f, texCoord = 0.0f, colour = 0.0f;
    bool operator==(const AttributeWeights&) const = default;
};

/// The error of a level that is compared with a tolerance: the distance, or a weighted attribute that differs
/// more.
struct ErrorMeasure
{
    AttributeWeights weights{};
    ErrorKind kind = ErrorKind::maximum; ///< of measured distances; estimates have one kind
};

/// The levels that may be chosen.
struct AllowedLevels
{
    std::uint32_t mostSteps = std::numeric_limits<std::uint32_t>::max();
    std::span<const std::uint32_t> drawable{}; ///< in steps, ascending from 0; empty: all levels
};

/// Returns the largest of a level's errors, as a distance in the model's units.
inline float errorOf(const LevelError& error, const AttributeWeights& weights)
{
    float most = error.distance;
    for (const float attribute :
         {weights.normal * error.normal, weights.texCoord * error.texCoord, weights.colour * error.colour})
        most = attribute > most ? attribute : most;
    return most;
}

/// Returns the coarsest level whose error is at most `tolerance`; level 0 if there is none. Measured errors
/// need not rise from level to level: a coarser level may keep a tolerance that a finer one does not. Units
/// of the tolerance: the model's positions. Cost: log n; where the allowed levels exclude the answer, linear
/// in the measured levels.
std::uint32_t coarsestWithin(const LevelTable& table, double tolerance, const ErrorMeasure& measure = {},
                             const AllowedLevels& allowed = {});

/// Returns the same with hysteresis. The held level stays while its error is at most `tolerance` and no
/// coarser level is within `tolerance` / `band`²; else the result is the coarsest level within `tolerance` /
/// `band`. So the tolerance always holds, and the band costs some detail. The first choice, with no level
/// held, needs no band: it is the coarsest level within `tolerance`. `band` ≥ 1: a factor of distance, see
/// kDefaultBand. Cost: that of one or two searches.
/// Source: the authors; viewlod/ScreenError.h has the bound in pixels.
std::uint32_t heldWithin(const LevelTable& table, double tolerance, double band, HeldLevel held,
                         const ErrorMeasure& measure = {}, const AllowedLevels& allowed = {});

/// Returns the error, in the model's units, that covers `tolerancePx` pixels at any point of the image; so
/// turning the camera about its eye changes no level. It is the inverse of viewlod::screenErrorBoundPx().
/// `depthM`: from the eye to the nearest point of the bounding sphere, at least the near distance.
double tolerableError(double tolerancePx, double pixelsPerTangent, double depthM, double metresPerUnit);

} // namespace osgPMObjects::core
