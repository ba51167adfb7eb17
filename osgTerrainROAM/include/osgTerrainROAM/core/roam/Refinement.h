// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <viewlod/ScreenError.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// Whether a split vertex is active for an eye: p_v = K·e_v / max(|eye − X_v| − r_v, n) > τ.
/// A pure function of the eye; it nests, so the active vertices form a conforming mesh without forced splits.
/// Source: spec 1 D, "The wheel in formulas", Priority.
class ActiveForEye
{
public:
    ActiveForEye(const viewlod::ViewState& view, double tolerancePx)
        : _eye(view.eyeWorld),
          _reachPerErrorM(view.guaranteedPixelsPerTangent() / tolerancePx),
          _nearM(view.nearM)
    {
    }

    /// Without a root: p > τ exactly when both K·e/τ > n and K·e/τ + r > |eye − X|.
    bool operator()(const SplitBound& bound) const
    {
        const double reach = _reachPerErrorM * bound.errorM;
        const glm::dvec3 offset = glm::dvec3(bound.centre) - _eye;
        return isActive(reach, reach + bound.radiusM, glm::dot(offset, offset));
    }

    /// The answer, and how much the eye may travel, plus e_v times the change of K/τ, before it can change.
    struct Verdict
    {
        bool active;
        double marginM;
        double distanceM; ///< from the eye to what lies below the vertex, at least
    };
    Verdict verdict(const SplitBound& bound) const
    {
        const double reach = _reachPerErrorM * bound.errorM, limit = reach + bound.radiusM;
        const glm::dvec3 offset = glm::dvec3(bound.centre) - _eye;
        const double distance2 = glm::dot(offset, offset);
        const bool active = isActive(reach, limit, distance2);
        const double distance = std::sqrt(distance2), beyond = distance - limit;
        // To be active takes both conditions: an inactive vertex has as long as the one that it misses by more.
        return {active, active ? std::min(reach - _nearM, -beyond) : std::max(_nearM - reach, beyond),
                distance - bound.radiusM};
    }

private:
    bool isActive(double reach, double limit, double distance2) const
    {
        return reach > _nearM && limit * limit > distance2;
    }

    glm::dvec3 _eye;
    double _reachPerErrorM;
    double _nearM;
};

/// View-independent: e_v > errorM.
struct ActiveForError
{
    double errorM;
    bool operator()(const SplitBound& bound) const { return bound.errorM > errorM; }
};

/// The predicate compares squares where priorities divide: a tolerance that shall exclude a priority is this much larger.
inline constexpr double kPriorityRounding = 1.0 + 1e-12;

/// p_v in pixels.
inline double priorityPx(const viewlod::ViewState& view, const SplitBound& bound)
{
    return viewlod::screenErrorBoundPx(view.guaranteedPixelsPerTangent(), bound.errorM,
                                       glm::distance(glm::dvec3(bound.centre), view.eyeWorld), bound.radiusM,
                                       view.nearM);
}

} // namespace osgTerrainROAM::core
