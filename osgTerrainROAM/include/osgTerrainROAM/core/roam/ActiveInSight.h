// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

/// Decides whether a split vertex is active for an eye and what its cameras see: its priority exceeds the
/// tolerance, and the ball around everything below it is in sight. What is not seen is as coarse as the rest
/// allows. The balls nest as the priorities do, so the active vertices form a conforming mesh here, too.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), sections 1 and 5.2 (detail
/// by the position and the orientation of the camera).
class ActiveInSight
{
public:
    /// `sight` must live as long.
    ActiveInSight(const viewlod::ViewState& view, double tolerancePx, const viewlod::Sight& sight)
        : _eye(view, tolerancePx), _sight(sight), _seesAll(sight.isEverything())
    {
    }

    bool operator()(const SplitBound& bound) const { return _eye(bound) && sees(bound); }

    /// The decision; the margin is that of ActiveForEye, none where the decision depends on what is seen.
    ActiveForEye::Verdict verdict(const SplitBound& bound) const
    {
        ActiveForEye::Verdict verdict = _eye.verdict(bound);
        if (_seesAll || !verdict.active) return verdict;
        constexpr double kNoMargin = -1.0;
        verdict.active = sees(bound);
        verdict.marginM = kNoMargin;
        return verdict;
    }

    bool sees(const SplitBound& bound) const
    {
        return _seesAll || _sight.touches(glm::dvec3(bound.centre), bound.radiusM);
    }

private:
    ActiveForEye _eye;
    const viewlod::Sight& _sight;
    bool _seesAll;
};

} // namespace osgTerrainROAM::core
