// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/vdpm/BoundedForest.h>

namespace osgTerrainROAM::core
{

/// What of a surface is seen besides its distance: splits of what is not seen are not wanted.
struct SeenPart
{
    bool inFrustum = false;                  ///< only what the view's frustum touches
    viewlod::Sight sight{};                  ///< only what is in sight
    VisibleSides sides = VisibleSides::both; ///< only what shows such a side, where the forest has cones

    bool isEverything() const { return !inFrustum && sight.isEverything() && sides == VisibleSides::both; }
};

/// Decides whether a split is wanted. For an eye: whether its bound on the screen exceeds the tolerance, p >
/// τ (ActiveForEye), and its ball and cone are not certainly out of the part that is seen. For no eye:
/// whether e > errorM.
/// All of these nest: where a ball is outside the frustum, those inside it are; where a cone is turned away,
/// those inside it are.
class SplitCriterion
{
public:
    SplitCriterion(const viewlod::ViewState& view, double tolerancePx, SeenPart seen = {})
        : _active(view, tolerancePx), _view(view), _tolerancePx(tolerancePx), _seen(std::move(seen))
    {
    }

    explicit SplitCriterion(double errorM) : _active({}, 1.0), _errorM(errorM) {}

    const viewlod::ViewState& view() const { return _view; }
    double tolerancePx() const { return _tolerancePx; }
    double scale() const
    {
        return _tolerancePx > 0.0 ? _view.guaranteedPixelsPerTangent() / _tolerancePx : 0.0;
    }

    /// Whether the decisions can be deferred: they depend on the distance from the eye alone.
    bool isDeferrable() const { return _seen.isEverything() && !_errorM; }

    /// The margin is that of ActiveForEye; none where the decision depends on what is seen.
    struct Verdict
    {
        bool wanted;
        double marginM;
    };
    Verdict verdict(const BoundedForest& forest, std::uint32_t split) const
    {
        const SplitBound& bound = forest.bounds[split];
        if (_errorM) return {bound.errorM > *_errorM, kNoMargin};
        const ActiveForEye::Verdict eye = _active.verdict(bound);
        if (_seen.isEverything()) return {eye.active, eye.marginM};
        if (!eye.active) return {false, eye.marginM}; // whatever is seen
        return {isSeen(forest, split), kNoMargin};
    }

    /// The bound on the screen, 0 where nothing is seen. Units: pixels.
    double errorPx(const BoundedForest& forest, std::uint32_t split) const
    {
        return isSeen(forest, split) ? priorityPx(_view, forest.bounds[split]) : 0.0;
    }

private:
    bool isSeen(const BoundedForest& forest, std::uint32_t split) const
    {
        const SplitBound& bound = forest.bounds[split];
        const glm::dvec3 centre(bound.centre);
        if (_seen.inFrustum && _view.frustum.classify(centre, bound.radiusM).outside) return false;
        if (!_seen.sight.touches(centre, bound.radiusM)) return false;
        return forest.cones.empty() ||
               !isTurnedAway(forest.cones[split], centre, bound.radiusM, _view.eyeWorld, _seen.sides);
    }

    static constexpr double kNoMargin = -1.0;

    ActiveForEye _active;
    viewlod::ViewState _view;
    double _tolerancePx = 0.0;
    SeenPart _seen;
    std::optional<double> _errorM;
};

} // namespace osgTerrainROAM::core
