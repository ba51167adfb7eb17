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

/// Decides whether a split vertex is active for an eye: whether its priority exceeds the tolerance, p_v > τ.
/// The priority p_v is viewlod::screenErrorBoundPx() of the vertex's error, position and radius; here it is
/// compared without a root or a division. The decision depends on the eye alone. Priorities nest, so the
/// active vertices form a conforming mesh without forced splits.
/// Source: Lindstrom & Pascucci, *Visualization of large terrains made easy*, 2001 (nested error and radius).
class ActiveForEye
{
public:
    ActiveForEye(const viewlod::ViewState& view, double tolerancePx)
        : _eye(view.eyeWorld),
          _reachPerErrorM(view.guaranteedPixelsPerTangent() / tolerancePx),
          _nearM(view.nearM)
    {
    }

    bool operator()(const SplitBound& bound) const { return Terms(*this, bound).areActive(_nearM); }

    /// The decision, and the margin of it: how far the eye may travel, plus e_v times the change of K/τ,
    /// before the decision can change. Units: metres.
    struct Verdict
    {
        bool active;
        double marginM;
        double distanceM; ///< least distance from the eye to the samples below the vertex
    };
    Verdict verdict(const SplitBound& bound) const
    {
        const Terms terms(*this, bound);
        const bool active = terms.areActive(_nearM);
        const double distance = std::sqrt(terms.distance2), beyond = distance - terms.limit;
        // Both conditions have to hold: an inactive vertex stays so until the one that fails by more can
        // hold.
        return {active,
                active ? std::min(terms.reach - _nearM, -beyond) : std::max(_nearM - terms.reach, beyond),
                distance - bound.radiusM};
    }

private:
    /// p_v > τ exactly when K·e/τ exceeds the near distance n, and K·e/τ + r exceeds the distance |eye − X|.
    struct Terms
    {
        Terms(const ActiveForEye& active, const SplitBound& bound)
            : reach(active._reachPerErrorM * bound.errorM), limit(reach + bound.radiusM)
        {
            const glm::dvec3 offset = glm::dvec3(bound.centre) - active._eye;
            distance2 = glm::dot(offset, offset);
        }
        bool areActive(double nearM) const { return reach > nearM && limit * limit > distance2; }

        double reach, limit, distance2;
    };

    glm::dvec3 _eye;
    double _reachPerErrorM;
    double _nearM;
};

/// Decides for no eye in particular: a split vertex is active when e_v > errorM.
struct ActiveForError
{
    double errorM;
    bool operator()(const SplitBound& bound) const { return bound.errorM > errorM; }
};

/// The predicate compares squares where priorities divide: a tolerance that must exclude a priority is larger
/// by this factor.
inline constexpr double kPriorityRounding = 1.0 + 1e-12;

/// The priority p_v of a split vertex. Units: pixels.
inline double priorityPx(const viewlod::ViewState& view, const SplitBound& bound)
{
    return viewlod::screenErrorBoundPx(view.guaranteedPixelsPerTangent(), bound.errorM,
                                       glm::distance(glm::dvec3(bound.centre), view.eyeWorld), bound.radiusM,
                                       view.nearM);
}

} // namespace osgTerrainROAM::core
