// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

/// A few levels of a progressive mesh, the *rungs*, over one set of vertices. Each rung has its own list of
/// faces, in an order that suits the vertex cache at that level. Many instances share the lists and need no
/// indices of their own. A level between two rungs is drawn as the finer of them.
/// Invariant: isLadder(). Memory: 12 B a face of every rung: 41 B a face of the finest level with the default
/// ratio.
/// Source: the authors, instead of the sliding window of Forsyth, "Comparison of VIPM methods" (2001): that
/// keeps one list for each run of steps in which no face changes twice; such runs are short, and their order
/// in the cache is poor.
struct LevelLadder
{
    /// The default for the faces of a rung divided by those of the next finer one, √½: on average a fifth
    /// more triangles are drawn than needed. With ½ it would be up to twice as many.
    static constexpr double kDefaultRatio = 0.70710678;

    struct Rung
    {
        std::uint32_t steps = 0;
        std::uint32_t faces = 0;
        std::uint32_t wedges = 0; ///< the rung uses this many wedges, the first ones
        bool operator==(const Rung&) const = default;
    };

    std::vector<Rung> rungs;          ///< finest first, from step 0 to the last step of the table
    std::vector<std::uint32_t> steps; ///< by rung: its steps, for SelectableObject::drawable
    std::uint32_t groups = 0;
    std::vector<std::uint32_t>
        ends; ///< by rung and group: the end of its faces; they begin at the previous entry's end
    std::vector<Triangle> faces;

    /// Builds the ladder. `table`: of the same mesh; `ratio`: faces of a rung / faces of the next finer one,
    /// above 0, below 1.
    /// Cost: that of playing all steps once a rung, and of ordering the faces.
    static LevelLadder of(const ProgressiveMesh& progressive, const LevelTable& table,
                          double ratio = kDefaultRatio);

    /// Returns the coarsest rung that is no coarser than a level.
    std::uint32_t rungOf(std::uint32_t levelSteps) const;
    /// Returns the range of `faces` that one group has on a rung.
    SlotRange facesOf(std::uint32_t rung, std::uint32_t group) const;
};

/// Tells whether rungs get coarser, faces and ends fit, and no face uses a wedge that its rung does not have.
bool isLadder(const LevelLadder& ladder);

} // namespace osgPMObjects::core
