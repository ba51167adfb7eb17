// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// How the faces of all levels are kept in order in one index buffer.
enum class Arrangement
{
    plain,   ///< faces in the order in which vsplits bring them: nothing moves, the cache is wasted
    tswap,   ///< the paper's: cycles of faces that fill holes by what costs the cache least
    blocks,  ///< cycles inside small blocks, half-empty neighbours merged
    windows, ///< ours: neighbouring blocks ordered anew when they have room in one less
};

/// What an arrangement may cost.
struct ArrangementSettings
{
    Arrangement arrangement = Arrangement::windows;
    std::uint32_t cacheSize = 16; ///< vertices that the target's queue of transformed ones holds
    /// Faces of a block. 0: as suits the arrangement.
    std::uint32_t blockFaces = 0;
    /// *windows*: so many blocks become one less at a time. More keep a better order for more moves: 2 moves a step with 2, 4 with 3.
    std::uint32_t windowBlocks = 3;
    /// *tswap*: the share of the faces that vanishes from one ordering to the next, the paper's atomic step. Smaller: a better order,
    /// for more moves.
    float tswapStep = 0.1f;
    /// *tswap*: what a face that stays where it is, and a line of the processor's cache that is touched anyway, are worth, in
    /// transformed vertices.
    float stayWeight = 1.0f, touchedLineWeight = 0.25f;
};

/// Faces of one material, which one call draws.
struct FaceGroup
{
    std::uint32_t material = 0;
    std::uint32_t firstBlock = 0; ///< up to the next group's
    bool operator==(const FaceGroup&) const = default;
};

/// A run of slots that fill and empty together.
struct FaceBlock
{
    std::uint32_t firstSlot = 0; ///< up to the next block's
    std::uint32_t extent = 0;    ///< slots of it that are drawn at the coarsest level, holes among them
    bool operator==(const FaceBlock&) const = default;
};

/// A mesh with all of its levels, which differ by one position each: a *progressive mesh*. Levels are told by the steps that lead to
/// them from the finest, 0. Vertices lie in split order, so a level uses the first of them alone; a step patches corners of a few
/// faces and moves some, forth (ecol) and back (vsplit). What there is of the faces is the coarsest level and the steps.
/// It never changes: what changes with the level is an index buffer, ProgressiveLevel, of which there may be many.
/// Invariant: isValid() below. Threads: may be read by any number.
/// Memory: that of the vertices, and overheadBytes().
/// Source: Hoppe, "Progressive meshes" (1996); paper 003, §4 and §5; Forsyth (2001). Differs: vertices that become others are a table of
/// parents instead of a number in each step; faces lie in blocks with holes (Arrangement::windows).
struct ProgressiveMesh
{
    /// Errors are kept for one step in so many: a level is then at most so much better than asked for.
    static constexpr std::uint32_t kErrorStride = 64;

    /// Positions, wedges and materials; no faces. Step k takes the last position of those left, and its wedges, the last of the wedges.
    Mesh mesh;
    std::vector<std::uint32_t> parents; ///< by wedge: what it becomes, below its own number; itself: nothing
    std::vector<FaceGroup> groups;
    std::vector<FaceBlock> blocks;
    std::uint32_t slotCount = 0;
    std::vector<Triangle> base; ///< the coarsest level: what is drawn of each block; a hole has equal corners
    std::vector<std::byte> records; ///< one for each step from the finest level, StepRecord.h
    std::uint32_t stepCount = 0;
    int slotBytes = 0, wedgeBytes = 0; ///< of numbers in records
    LevelError finestError;            ///< of level 0: not that of the original if finer steps were left out
    std::vector<LevelError>
        errors; ///< of the levels after kErrorStride steps, twice as many …, and after all

    /// What players have to hold at once.
    std::uint32_t mostSlotsOfStep = 0; ///< patched and vanished faces of one step
    std::uint32_t mostRearrangements = 0;
    std::uint32_t mostSlotsMoved = 0; ///< by one rearrangement

    std::uint32_t endSlot(std::uint32_t block) const
    {
        return block + 1 < blocks.size() ? blocks[block + 1].firstSlot : slotCount;
    }
    /// The first block that is not of a group any more.
    std::uint32_t endBlock(std::uint32_t group) const
    {
        return group + 1 < groups.size() ? groups[group + 1].firstBlock
                                         : static_cast<std::uint32_t>(blocks.size());
    }

    /// How many wedges there are after some steps: the first ones.
    std::uint32_t wedgesAfter(std::uint32_t steps) const;

    /// Bytes besides the vertices and one index buffer. Indices below 65 535 count two bytes.
    std::size_t overheadBytes() const;
};

/// Makes a progressive mesh. Wedges at one position with equal attributes should be one (consolidation sees to that).
/// The sequence has to be one of the mesh (isSequenceOf), with subset placement.
/// Cost: that of the arrangement; *windows* takes some µs a face.
ProgressiveMesh buildProgressiveMesh(const Mesh& mesh, const CollapseSequence& sequence,
                                     const ArrangementSettings& settings = {});

/// How many steps can be made without the distance going above a tolerance, as far as the errors that are kept tell.
std::uint32_t stepsToDistance(const ProgressiveMesh& progressive, double tolerance);

/// An upper bound of the errors after some steps.
LevelError errorAfter(const ProgressiveMesh& progressive, std::uint32_t steps);

/// Whether every step can be played, forth and back, without leaving any array, and with faces of this mesh at every level.
bool isValid(const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
