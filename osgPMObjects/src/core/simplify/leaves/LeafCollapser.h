// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "../collapse/CollapseState.h"
#include "../collapse/Collapser.h"
#include "Leaf.h"

namespace osgPMObjects::core
{

/// Collapses the cards of one material to nothing, two near ones to one again and again, which grows for what is no longer seen of the other. What a
/// pair costs is how far its areas are moved, as a quadric weighs it, and how large the smaller one is; cards deep among others count little, for
/// they are not seen.
/// The steps of a pair belong together: first the faces of one go, then corners of the other move, so a level that ends between them lacks
/// area and nothing else. With subset placement corners go into those of the card that has gone, so long as both show the same of the texture; else positions of
/// it that have no faces any more are used up to move corners.
/// Frame, units: of the state. Threads: one each, on different cards. Cost: n log n; some 20 µs a card.
/// Source: Remolar et al., "Geometric simplification of foliage" (2002), §3 (leaf collapse: two leaves become one); Cook et al., "Stochastic
/// simplification of aggregate detail" (2007), §3.2 (what is left grows, so that the area stays). Ours: the steps, so that levels stay prefixes of
/// one sequence; what is to stay is what is seen, and no card leaves the box of those that it stands for: at full area an oak covers 1.6 times as
/// many pixels at 1 %.
class LeafCollapser
{
public:
    explicit LeafCollapser(CollapseState& state) : _state(state) {}

    PartialSequence run(std::vector<LeafCard> cards);

private:
    /// A leaf's cheapest neighbour.
    struct Partner
    {
        double cost = std::numeric_limits<double>::infinity();
        std::uint32_t leaf = ~0u; ///< ~0: none is near, or it has changed
    };

    void findPartners();
    std::size_t findPartners(double distance);
    double pairCost(const Leaf& a, const Leaf& b) const;
    void mergeCheapest();
    LeafGrowth growthOf(const Leaf& gone, const Leaf& stays) const;
    void merge(std::uint32_t first, std::uint32_t second);
    void close(const Leaf& leaf, bool isTurned);
    void grow(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth);
    void takeCorners(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth);
    void moveCorners(Leaf& leaf, const LeafGrowth& growth);
    LevelError errorOf(const Leaf& gone, const Leaf& stays, const LeafGrowth& growth) const;
    void removeLast();
    void addStep(std::uint32_t from, std::uint32_t to, std::uint32_t faces, const glm::dvec3& place);
    void joinWedges(const LeafCard::Corner& from, const LeafCard::Corner& to);

    CollapseState& _state;
    std::vector<Leaf> _leaves;
    std::vector<Partner> _partners;   ///< by leaf
    std::vector<std::uint32_t> _left; ///< leaves, in rising order
    Urgency _urgency;                 ///< of the steps that are being made
    LevelError _error;                ///< the same
    PartialSequence _done;
};

} // namespace osgPMObjects::core
