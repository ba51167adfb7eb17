// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace osgTerrainROAM::core
{

/// What frames take with patches of different sizes, and the size that they take least with.
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

/// Finds the balance of processor and graphics card by measuring this machine. `frameMs` draws one frame, to its end, with
/// patches of 2^k triangles and returns the time that it took; it is asked in turns, so that other work on the machine
/// meets all alike, and its first answer for each k, which builds the mesh, does not count. Of exponents whose medians
/// differ by less than 3 % the smaller wins. Precondition: at least one exponent, ascending; frames > 0.
/// Source: spec 1, "the balance is a parameter"; paper 1, §5.
PatchBalance measurePatchBalance(std::span<const int> exponents, int frames,
                                 const std::function<double(int exponent)>& frameMs);

} // namespace osgTerrainROAM::core
