// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/surface/PlanFrame.h>

namespace osgMultiTriangulation::core
{

/// What the directory of a file tells of a tree.
struct MtEntry
{
    std::uint64_t offset = 0; ///< of its bytes in the file
    std::uint32_t bytes = 0;
    std::uint32_t checksum = 0;                     ///< CRC-32 of the table of its sections
    std::uint32_t parent = 0;                       ///< 0xffffffff: the main part
    std::int32_t low[2] = {0, 0}, high[2] = {0, 0}; ///< its extent on the lattice
    std::uint32_t points = 0, triangles = 0, fragments = 0, rootTriangles = 0;
    float rootError = 0.0f; ///< greatest of its root's triangles, metres

    bool operator==(const MtEntry&) const = default;
};

/// What the beginning of a file tells.
struct MtInfo
{
    PlanFrame frame;
    double heightStep = 0.0;                 ///< all heights are multiples of it; 0: of nothing
    std::uint64_t points = 0, triangles = 0; ///< of the surface
    std::vector<MtEntry> trees;              ///< parents before children; 0 is the main part

    bool operator==(const MtInfo&) const = default;
};

} // namespace osgMultiTriangulation::core
