// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "../quadric/StarQuadric.h"
#include "Leaf.h"

namespace osgPMObjects::core
{

/// Cost of a removed leaf where it was, in moves by its own size: it is missed there, however near the other
/// one is.
constexpr double kMissedLeaf = 2.0;

/// The cheapest near leaf of each leaf, to merge with.
class LeafPartners
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    struct Partner
    {
        double cost = std::numeric_limits<double>::infinity();
        std::uint32_t leaf = kNone; ///< kNone: none is known
    };

    explicit LeafPartners(const AreaWeight& weight) : _weight(weight) {}

    /// Finds partners for leaves without one, until some leaf has one. `left`: numbers of at least two
    /// leaves.
    void find(std::span<const Leaf> leaves, std::span<const std::uint32_t> left);

    const Partner& of(std::uint32_t leaf) const { return _partners[leaf]; }
    void forget(std::uint32_t leaf) { _partners[leaf] = {}; }

private:
    std::size_t findWithin(double distance, std::span<const Leaf> leaves,
                           std::span<const std::uint32_t> left);
    double cost(const Leaf& a, const Leaf& b) const;

    AreaWeight _weight;
    std::vector<Partner> _partners; ///< by leaf
};

} // namespace osgPMObjects::core
