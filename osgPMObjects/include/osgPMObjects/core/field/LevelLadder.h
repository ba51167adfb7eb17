// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

/// A few levels of a progressive mesh, each with a list of faces of its own in the order that suits the cache best at that
/// level, over the one set of vertices: for many instances, which share the lists and need no indices of their own.
/// A level between two *rungs* is drawn as the finer of them.
/// Invariant: isLadder(). Memory: 12 B a face of every rung: 41 B a face of the finest level with the default ratio.
/// Source: in place of the sliding window of Forsyth, "Comparison of VIPM methods" (2001), which keeps one list for
/// runs of steps within which no face changes twice: those are short, and its order in the cache is poor.
struct LevelLadder
{
    /// Faces of a rung to those of the next finer one: half as many triangles as needed would be drawn with .5 at worst,
    /// a fifth more in the mean with the root of it.
    static constexpr double kDefaultRatio = 0.70710678;

    struct Rung
    {
        std::uint32_t steps = 0;
        std::uint32_t faces = 0;
        std::uint32_t wedges = 0; ///< it uses the first so many
        bool operator==(const Rung&) const = default;
    };

    std::vector<Rung> rungs;          ///< finest first, from no steps to as many as the table has
    std::vector<std::uint32_t> steps; ///< by rung, as the rules want them (SelectableObject::drawn)
    std::uint32_t groups = 0;
    std::vector<std::uint32_t>
        ends; ///< by rung and group: where its faces end; they begin where the last end
    std::vector<Triangle> faces;

    /// `table`: of the mesh. Cost: that of playing all steps once a rung, and of ordering the faces.
    static LevelLadder of(const ProgressiveMesh& progressive, const LevelTable& table,
                          double ratio = kDefaultRatio);

    /// The coarsest rung that is no coarser than a level.
    std::uint32_t rungOf(std::uint32_t levelSteps) const;
    /// The faces of one group on a rung, as slots of `faces`.
    SlotRange facesOf(std::uint32_t rung, std::uint32_t group) const;
};

/// Whether rungs get coarser, faces and ends fit, and no face uses a wedge that its rung does not have.
bool isLadder(const LevelLadder& ladder);

} // namespace osgPMObjects::core
