// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <osgRoads/core/network/Road.h>
#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Collects what is painted along the borders of chunks; equal rows are kept once.
class MarkRows
{
public:
    MarkRows() : _rows(1) {}

    /// Returns the row of a lane's outer border (of the centre lane: of the lane offset) for a chunk that
    /// begins at `s`. 0: nothing is painted, or explicit lines are, which are decals.
    std::uint32_t rowOf(const LaneSection& section, const Lane& lane, double s);

    std::vector<MarkRow> take() { return std::move(_rows); }

private:
    std::vector<MarkRow> _rows;
    std::map<std::array<float, 16>, std::uint32_t> _known;
};

} // namespace osgRoads::core
