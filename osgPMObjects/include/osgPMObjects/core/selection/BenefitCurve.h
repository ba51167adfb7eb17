// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/selection/ScreenErrorRule.h>

namespace osgPMObjects::core
{

/// What drawing a level costs. All in one unit of the caller's, whole numbers so that sums are exact in any order:
/// triangles (1 a triangle, nothing else), or nanoseconds of a machine that was measured.
struct CostModel
{
    double perTriangle = 1.0;
    double perVertex = 0.0; ///< of those that the level uses, V minus its steps; attributes split none more
    double perDraw = 0.0;   ///< of an object, however coarse

    bool operator==(const CostModel&) const = default;

    /// Rounded up.
    std::uint64_t of(std::uint32_t triangles, std::uint32_t vertices) const;
};

/// A level that is worth considering under a budget.
struct BenefitPoint
{
    std::uint32_t steps = 0;
    std::uint64_t cost = 0; ///< of the CostModel
    double gain = 0.0;      ///< 0 of the coarsest level to at most 1 of a level without error
    float error = 0.0f;     ///< errorOf() it, in the model's units
};

/// The levels of a model that are worth their cost, coarsest first: of all, those on the upper hull of gain over cost.
/// The gain of a level is how much of the object's size its error leaves right: 1 - error / radius, not below 0, over that
/// of the coarsest. Scaled by an instance's size in the picture and its importance it is the benefit; the hull stays the
/// same, so it is made once a model.
/// Invariant: isBenefitCurve(): cost and gain rise, gain by cost falls from point to point.
/// Source: Funkhouser & Séquin, "Adaptive display algorithm for interactive frame rates" (1993), 4: Benefit = Size ·
/// Accuracy · Importance. Differs: accuracy from the measured distance instead of a power of the number of samples; the hull.
struct BenefitCurve
{
    std::vector<BenefitPoint> points;

    std::uint32_t last() const { return static_cast<std::uint32_t>(points.size()) - 1; }

    /// `radius`: of the model's bounding sphere, in its units; above 0. `levels`: how many levels, by faces in equal
    /// ratios, the hull is taken of.
    /// Errors of 0 are worth nothing: the finest point is the cheapest level without error.
    static BenefitCurve of(const LevelTable& table, double radius, const CostModel& cost,
                           const AttributeWeights& weights = {}, std::uint32_t levels = 32);
    /// The same of given levels, in steps: those that can be drawn.
    static BenefitCurve ofLevels(const LevelTable& table, std::span<const std::uint32_t> levels,
                                 double radius, const CostModel& cost, const AttributeWeights& weights = {});
    /// The hull of any points, sorted by cost; `points` is not empty.
    static BenefitCurve hullOf(std::vector<BenefitPoint> points);
};

bool isBenefitCurve(const BenefitCurve& curve);

} // namespace osgPMObjects::core
