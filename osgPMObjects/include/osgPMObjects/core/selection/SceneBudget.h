// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/selection/BenefitCurve.h>
#include <osgPMObjects/core/selection/CandidateHeap.h>

namespace osgPMObjects::core
{

/// One object that shares a budget. Its state between frames is its current point of the curve, kept by the
/// caller.
struct BudgetedObject
{
    const BenefitCurve* curve = nullptr;
    /// worth of a gain of 1, at least 0: size in pixels squared times the square of the priority's gain
    double weight = 0.0;
    std::uint32_t finest = 0; ///< the finest point worth drawing: its error is within the tolerance
};

/// The result of sharing a budget.
struct BudgetResult
{
    std::uint64_t cost = 0;
    double benefit = 0.0;
    bool fits = true;            ///< false: even the coarsest levels cost more, and they are chosen
    std::uint32_t refined = 0;   ///< steps to finer points, summed over all objects
    std::uint32_t coarsened = 0; ///< steps to coarser points
    std::uint32_t refused = 0;   ///< objects that would be finer with a larger budget
    double refusedRate = 0.0;    ///< the largest benefit / cost of a refused step; 0: none was refused
};

/// Chooses the levels of all objects so that their summed benefit is large and their summed cost stays within
/// a budget. It begins at the last frame's levels. Objects get coarser, smallest benefit / cost first, until
/// the budget holds. Then objects get finer, largest benefit / cost first, as long as the budget holds. A
/// finer step may also take the cost from steps of other objects whose benefit / cost is smaller by the
/// factor `band`. The cost never exceeds the budget if the coarsest levels fit. With a band of 1 the result
/// is the greedy choice and does not depend on the last frame: its benefit is less than the best by at most
/// refusedRate times the cost of one step. A wider band costs at most refusedRate · cost · (1 - 1 / band)
/// more, and avoids flicker between objects of similar worth.
/// Deterministic: the smaller object number wins a tie. Memory: some 50 B an object, kept from frame to
/// frame. Cost: linear, and log n for each step that is taken, undone or refused.
/// Source: Funkhouser & Séquin, "Adaptive display algorithm for interactive frame rates" (1993), section 5
/// (incremental algorithm). Differs: convex curves, which make the bound provable; the band replaces their
/// factor of hysteresis; a step is undone only if the wanted step then fits.
class SceneBudget
{
public:
    /// A factor of benefit / cost. If one object approaches by 5 % and another recedes by 5 %, their ratio of
    /// sizes changes by (1.05 / 0.95)² = 1.22 each, by 1.22² = 1.49 together.
    static constexpr double kDefaultBand = 1.5;

    /// Chooses all points. `points`: by object, in and out; a number beyond the curve counts as its nearest
    /// point.
    /// `budget`: in the unit of the curves' costs. `band` ≥ 1.
    BudgetResult choose(std::span<const BudgetedObject> objects, std::span<std::uint32_t> points,
                        std::uint64_t budget, double band = kDefaultBand);

private:
    struct Step ///< the change from an object's point to the next coarser or finer one
    {
        double benefit = 0.0;
        std::uint64_t cost = 0;
    };

    std::uint32_t last(std::uint32_t object) const;
    Step stepTo(std::uint32_t object, std::uint32_t point) const;
    LevelCandidate finerCandidate(std::uint32_t object) const;
    LevelCandidate coarserCandidate(std::uint32_t object) const;
    void begin();
    void coarsenToFit();
    void refineByWorth(double band);
    void refine(std::uint32_t object);
    void coarsen(std::uint32_t object);
    bool makeRoom(const LevelCandidate& wanted, double band);
    void addUp();

    std::span<const BudgetedObject> _objects;
    std::span<std::uint32_t> _points;
    std::uint64_t _budget = 0;
    std::uint64_t _reach = 0; ///< upper limit of the cost of the finer candidates that are left
    BudgetResult _result;
    CandidateHeap<true> _finer;
    CandidateHeap<false> _coarser;
    std::vector<LevelCandidate> _asked; ///< steps that may be undone to make room
};

} // namespace osgPMObjects::core
