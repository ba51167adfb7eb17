// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/selection/ScreenErrorRule.h>

namespace osgPMObjects::core
{

/// The cost of drawing a level. All costs have one unit, chosen by the caller: triangles (1 each, the
/// default), or nanoseconds measured on a machine. Costs are rounded to whole numbers, so that sums are exact
/// in any order.
struct CostModel
{
    static constexpr double kMostEach = 1e9; ///< so that no cost overflows; each is 0 … kMostEach

    double perTriangle = 1.0;
    double perVertex =
        0.0;              ///< of the vertices that the level uses: positions of the full mesh minus its steps
    double perDraw = 0.0; ///< of an object, whatever its level

    bool operator==(const CostModel&) const = default;

    /// Returns the cost of an object, rounded up.
    std::uint64_t of(std::uint32_t triangles, std::uint32_t vertices) const;
};

/// A level that is worth its cost.
struct BenefitPoint
{
    std::uint32_t steps = 0;
    std::uint64_t cost = 0; ///< in the unit of the CostModel
    double gain = 0.0;      ///< 0 for the coarsest level, at most 1 for a level without error
    float error = 0.0f;     ///< errorOf() the level, in the model's units
};

/// The levels of a model that are worth their cost, coarsest first: those on the upper convex hull of gain
/// over cost. The gain of a level is its accuracy minus that of the coarsest level; its accuracy is 1 - error
/// / radius, at least 0. The benefit is the gain times the instance's size on the screen and its importance.
/// These factors do not change the hull, so one curve serves all instances of a model.
/// Invariant: isBenefitCurve(): cost and gain rise, gain / cost falls from point to point.
/// Source: Funkhouser & Séquin, "Adaptive display algorithm for interactive frame rates" (1993), section 4:
/// Benefit = Size · Accuracy · Importance. Differs: accuracy from the measured distance, not from a power of
/// the number of samples; the hull.
struct BenefitCurve
{
    std::vector<BenefitPoint> points;

    std::uint32_t last() const { return static_cast<std::uint32_t>(points.size()) - 1; }

    /// Takes the hull of `levels` levels whose numbers of faces are in equal ratios.
    /// `radius`: of the model's bounding sphere, in its units; above 0. The finest point is the cheapest
    /// level without error.
    static BenefitCurve of(const LevelTable& table, double radius, const CostModel& cost,
                           const ErrorMeasure& measure = {}, std::uint32_t levels = 32);
    /// Takes the hull of the given levels, in steps: those that can be drawn.
    static BenefitCurve ofLevels(const LevelTable& table, std::span<const std::uint32_t> levels,
                                 double radius, const CostModel& cost, const ErrorMeasure& measure = {});
    /// Takes the hull of any points, sorted by cost; `points` must not be empty.
    static BenefitCurve hullOf(std::vector<BenefitPoint> points);
};

bool isBenefitCurve(const BenefitCurve& curve);

} // namespace osgPMObjects::core
