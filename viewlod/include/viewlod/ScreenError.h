// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/glm.hpp>

#include <viewlod/ViewState.h>

namespace viewlod
{

/// Computes an upper bound, in pixels, of the projection of a world-space error `errorM` anywhere in a
/// sphere: p = K·e / max(|eye − X| − r, n), with K `pixelsPerTangent`, X and r the sphere's centre and
/// radius, n the near distance. K is either ViewState::pixelsPerTangent (image centre) or
/// guaranteedPixelsPerTangent() (whole image).
/// Source: Lindstrom & Pascucci, *Visualization of Large Terrains Made Easy*, 2001; the lower limit n is
/// ours.
inline double screenErrorBoundPx(double pixelsPerTangent, double errorM, double distanceToCentreM,
                                 double radiusM, double nearM)
{
    return pixelsPerTangent * errorM / std::max(distanceToCentreM - radiusM, nearM);
}

/// Projects `world` to pixels from the lower left corner of the image; nothing when it is nearer than the
/// near distance.
inline std::optional<glm::dvec2> projectPx(const ViewState& view, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1.0);
    if (clip.w < view.nearM) return std::nullopt;
    return glm::dvec2((clip.x / clip.w + 1.0) * 0.5 * view.widthPx,
                      (clip.y / clip.w + 1.0) * 0.5 * view.heightPx);
}

} // namespace viewlod
