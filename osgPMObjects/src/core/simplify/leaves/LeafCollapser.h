// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "../collapse/CollapseState.h"
#include "../collapse/Collapser.h"
#include "Leaf.h"
#include "LeafGrowth.h"
#include "LeafPartners.h"

namespace osgPMObjects::core
{

/// Merges near leaf cards of one material in pairs until none is left; the remaining card grows by the
/// visible area of the other. The cost of a pair is the displacement of its areas, weighed as by a quadric,
/// and the size of the smaller card. Cards deep inside the crown cost little, since they are not visible.
/// The steps of a pair belong together: first the faces of one card collapse, then corners of the other move.
/// A level between them has less area, but is valid. With subset placement, corners move to corners of
/// removed cards with the same texture coordinates; else positions of it without faces are used up to move
/// corners. Frame, units: of the state. Threads: one each, on different cards. Cost: n log n; some 20 µs a
/// card.
/// Source: Remolar et al., *Geometric simplification of foliage* (2002), section 3 (leaf collapse: two leaves
/// become one); Cook et al., *Stochastic simplification of aggregate detail* (2007), section 3.2 (remaining
/// elements grow to keep the area).
/// Differs: levels are prefixes of one sequence; the visible area is kept, and cards hardly leave the box of
/// the cards merged into them: with the full area an oak at 1 % covers 1.6 times its pixels.
class LeafCollapser
{
public:
    explicit LeafCollapser(CollapseState& state) : _state(state), _partners(state.weight) {}

    /// Merges cards until none is left and returns the steps.
    PartialSequence run(std::vector<LeafCard> cards);

private:
    void mergeCheapest();
    LeafGrowth growthOf(const Leaf& gone, const Leaf& stays) const;
    void merge(std::uint32_t first, std::uint32_t second);
    void close(const Leaf& leaf, bool isTurned);
    void grow(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth);
    void takeCorners(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth);
    void takeSpares(Leaf& leaf, const LeafGrowth& growth);
    void moveTo(LeafCard::Corner& own, const LeafCard::Corner& other);
    void moveCorners(Leaf& leaf, const LeafGrowth& growth);
    void removeLast();
    void addStep(std::uint32_t from, std::uint32_t to, std::uint32_t faces, const glm::dvec3& place);
    void joinWedges(const LeafCard::Corner& from, const LeafCard::Corner& to);

    CollapseState& _state;
    std::vector<Leaf> _leaves;
    LeafPartners _partners;
    std::vector<std::uint32_t> _left; ///< leaf numbers, rising
    Urgency _urgency;                 ///< of the current steps
    LevelError _error;                ///< of the current steps
    PartialSequence _done;
};

} // namespace osgPMObjects::core
