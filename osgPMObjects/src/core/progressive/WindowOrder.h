// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "FutureLevels.h"

namespace osgPMObjects::core
{

/// Orders the faces of a window so that they cost a vertex cache little from now to their next ordering,
/// while some of them vanish. Of several orders the one with the least cost by FutureLevels is taken.
/// Source: the authors.
class WindowOrder
{
public:
    WindowOrder(const LevelWalk& walk, std::uint32_t cacheSize)
        : _future(walk, cacheSize), _cacheSize(cacheSize)
    {
    }

    /// Returns the faces, all live at the walk's level, in another order.
    std::vector<std::uint32_t> ordered(const std::vector<std::uint32_t>& faces);

private:
    using Numbers = std::vector<std::uint32_t>; ///< of the faces in FutureLevels

    double consider(Numbers order);
    void tryLocality();
    double costOfPiece() const;
    Numbers orderForLater();

    FutureLevels _future;
    std::uint32_t _cacheSize;
    Numbers _best;
    std::uint64_t _least = 0;
    std::uint32_t _toSkip = 0, _skipped = 0; ///< windows to go without localityOrder(), and those that went
};

} // namespace osgPMObjects::core
