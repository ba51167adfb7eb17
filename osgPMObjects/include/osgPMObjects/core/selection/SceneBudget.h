// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/selection/BenefitCurve.h>
#include <osgPMObjects/core/selection/OfferHeap.h>

namespace osgPMObjects::core
{

/// One object that shares a budget. Its state between frames is the number of a point of its curve, kept by the caller.
struct BudgetedObject
{
    const BenefitCurve* curve = nullptr;
    double weight =
        0.0; ///< what a gain of 1 is worth here and now, at least 0: pixels squared times the square of the priority's gain
    std::uint32_t finest =
        0; ///< the last point that it has any use for, as its error is within the tolerance
};

/// What a budget came to.
struct BudgetResult
{
    std::uint64_t cost = 0;
    double benefit = 0.0;
    bool fits = true;            ///< false: not even the coarsest levels do, which are then chosen
    std::uint32_t refined = 0;   ///< points gone up by all objects
    std::uint32_t coarsened = 0; ///< points gone down
    std::uint32_t refused = 0;   ///< objects that would be finer with a larger budget
    double refusedRate = 0.0;    ///< the largest benefit by cost that was refused; 0: none was
};

/// The levels of all objects that give the most benefit for what they may cost together: from the last frame's choice,
/// objects whose last step was worth the least for its cost get coarser until the budget holds, and those for which the
/// next is worth most get finer while it does, or as long as others whose last step was worth less by `band` make room for
/// them. Never above the budget if the coarsest levels fit. With a band of 1 it is the greedy choice from nothing,
/// whatever was chosen before: less than the best by at most the benefit of one step, refusedRate times its cost. With a
/// wider one at most refusedRate · cost · (1 - 1 / band) less besides, and objects that change places in worth do not
/// flicker.
/// Deterministic: ties go by the objects' numbers. Memory: some 50 B an object, kept from frame to frame. Cost: linear,
/// and log n for each step taken, undone or refused while others could still make room.
/// Source: Funkhouser & Séquin (1993), 5: the incremental algorithm. Differs: convex curves, for which it is proved; the
/// band in place of their factor of hysteresis; a step is undone only for one that then fits.
class SceneBudget
{
public:
    /// A factor in benefit by cost. Back and forth by 5 % changes the size of one object over another's by (1.05 / 0.95)²
    /// = 1.22, when the one approaches as the other recedes by 1.22² = 1.49.
    static constexpr double kDefaultBand = 1.5;

    /// `points`: by object, in and out; numbers that the curve does not have are taken as its nearest.
    BudgetResult choose(std::span<const BudgetedObject> objects, std::span<std::uint32_t> points,
                        std::uint64_t budget, double band = kDefaultBand);

private:
    struct Step ///< from a point of an object to the next coarser or finer one
    {
        double benefit = 0.0;
        std::uint64_t cost = 0;
    };

    std::uint32_t last(std::uint32_t object) const;
    Step stepTo(std::uint32_t object, std::uint32_t point) const;
    Offer finerOffer(std::uint32_t object) const;
    Offer coarserOffer(std::uint32_t object) const;
    void begin();
    void coarsenToFit();
    void refineByWorth(double band);
    void refine(std::uint32_t object);
    void coarsen(std::uint32_t object);
    bool makeRoom(const Offer& wanted, double band);
    void addUp();

    std::span<const BudgetedObject> _objects;
    std::span<std::uint32_t> _points;
    std::uint64_t _budget = 0;
    std::uint64_t _reach = 0; ///< what the finer offers that are left may cost at most
    BudgetResult _result;
    OfferHeap<true> _finer;
    OfferHeap<false> _coarser;
    std::vector<Offer> _asked; ///< to make room
};

} // namespace osgPMObjects::core
