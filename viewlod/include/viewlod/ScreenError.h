// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/glm.hpp>

#include <viewlod/ViewState.h>

namespace viewlod
{

/// Upper bound, in pixels, of an error of `errorM` metres anywhere within `radiusM` of `centre`.
/// `pixelsPerTangent` chooses between centre pixels and the guarantee for the whole picture (ViewState).
/// Source: spec 1, "The wheel in formulas", priority p = K·e / max(|eye − X| − r, n).
inline double screenErrorBoundPx(double pixelsPerTangent, double errorM, double distanceToCentreM,
                                 double radiusM, double nearM)
{
    return pixelsPerTangent * errorM / std::max(distanceToCentreM - radiusM, nearM);
}

/// Where `world` falls in the picture, in pixels from its lower left corner; nothing when it is not beyond
/// the near distance.
inline std::optional<glm::dvec2> projectPx(const ViewState& view, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1.0);
    if (clip.w < view.nearM) return std::nullopt;
    return glm::dvec2((clip.x / clip.w + 1.0) * 0.5 * view.widthPx,
                      (clip.y / clip.w + 1.0) * 0.5 * view.heightPx);
}

} // namespace viewlod
