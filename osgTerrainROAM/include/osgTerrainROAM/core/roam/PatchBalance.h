// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace osgTerrainROAM::core
{

/// The frame times with patches of different sizes, and the size with the least.
struct PatchBalance
{
    struct Row
    {
        int exponent;
        double medianMs;
    };
    int exponent = 0;
    std::vector<Row> rows; ///< as asked for
};

/// Measures the balance of processor and graphics card on this machine. `frameMs` draws one whole frame with
/// patches of 2^k triangles and returns its time. The exponents are asked in turns, so that other work on the
/// machine affects all alike; the first answer for each k, which builds the mesh, does not count. Of
/// exponents whose medians differ by less than 3 % the smallest is chosen. Precondition: at least one
/// exponent, ascending; frames > 0.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.3 (the cost of the
/// processor against that of the graphics card).
PatchBalance measurePatchBalance(std::span<const int> exponents, int frames,
                                 const std::function<double(int exponent)>& frameMs);

} // namespace osgTerrainROAM::core
