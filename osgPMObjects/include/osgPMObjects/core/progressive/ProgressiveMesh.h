// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/progressive/ArrangementSettings.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>
#include <osgPMObjects/core/simplify/ErrorLadder.h>

namespace osgPMObjects::core
{

/// The faces of one material, drawn by one call.
struct FaceGroup
{
    std::uint32_t material = 0;
    std::uint32_t firstBlock = 0; ///< its blocks end where the next group's begin
    bool operator==(const FaceGroup&) const = default;
};

/// A run of consecutive slots that is filled and emptied as a whole.
struct FaceBlock
{
    std::uint32_t firstSlot = 0; ///< its slots end where the next block's begin
    std::uint32_t extent = 0;    ///< slots drawn at the coarsest level, holes included
    bool operator==(const FaceBlock&) const = default;
};

/// A *progressive mesh*: a mesh with all its levels of detail. Each level has one position less than the
/// finer one before it. A level is named by the number of *steps* (edge collapses) that lead to it from the
/// finest level, which is 0. Vertices lie in split order, so that a level uses the first ones only. A step
/// changes corners of a few faces (*patches* them), removes some and moves some; it can be undone (vertex
/// split). The faces are stored as the coarsest level and the steps. A progressive mesh never changes;
/// ProgressiveLevel holds the index buffer of one level.
/// Invariant: isValid(). Threads: any number may read it. Memory: that of the vertices, and overheadBytes().
/// Source: Hoppe, "Progressive meshes" (1996); *Cache-friendly view-independent progressive meshes*
/// (Graphicon 2003), sections 4 and 5; Forsyth, "Comparison of VIPM methods" (2001). Differs: a table of
/// parents tells what a vertex becomes, instead of a number in each step; faces lie in blocks with holes
/// (Arrangement::windows).
struct ProgressiveMesh
{
    /// Errors are kept for every kErrorStride-th step, so a chosen level may be this many steps finer than
    /// necessary.
    static constexpr std::uint32_t kErrorStride = 64;

    /// Positions, wedges and materials, without faces. Each step removes the last position left and its
    /// wedges, which are the last wedges.
    Mesh mesh;
    std::vector<std::uint32_t> parents; ///< by wedge: the lower wedge that replaces it; itself if none does
    std::vector<FaceGroup> groups;
    std::vector<FaceBlock> blocks;
    std::uint32_t slotCount = 0;
    std::vector<Triangle>
        base; ///< the coarsest level: the drawn slots of each block; a hole has equal corners
    std::vector<std::byte>
        records; ///< one record a step, from the finest level on (src/core/progressive/StepRecord.h)
    std::uint32_t stepCount = 0;
    int slotBytes = 0, wedgeBytes = 0; ///< width of slots and wedges in records
    LevelError finestError;            ///< estimate for level 0; not 0 where finer steps were left out
    /// estimates, of the levels after kErrorStride, 2 kErrorStride, … steps, and of the last level
    std::vector<LevelError> errors;
    /// The measured errors of some levels, from level 0 on; empty: not measured (measureLevels()). Invariant:
    /// areMeasured().
    std::vector<MeasuredLevel> ladder;

    /// The sizes of the buffers that a ProgressiveLevel allocates.
    std::uint32_t mostSlotsOfStep = 0; ///< patched and vanished faces of one step
    std::uint32_t mostRearrangements = 0;
    std::uint32_t mostSlotsMoved = 0; ///< of one rearrangement; of cycles, which move in place: holes closed

    std::uint32_t endSlot(std::uint32_t block) const
    {
        return block + 1 < blocks.size() ? blocks[block + 1].firstSlot : slotCount;
    }
    /// Returns the end of a group's blocks (the first block of the next group).
    std::uint32_t endBlock(std::uint32_t group) const
    {
        return group + 1 < groups.size() ? groups[group + 1].firstBlock
                                         : static_cast<std::uint32_t>(blocks.size());
    }

    /// Returns how many wedges the level after `steps` steps uses: the first ones.
    std::uint32_t wedgesAfter(std::uint32_t steps) const;

    /// Returns the bytes besides the vertices and one index buffer. Indices below 65 535 count two bytes.
    std::size_t overheadBytes() const;
};

/// Makes a progressive mesh. Consolidate the mesh first: wedges at one position with equal attributes should
/// be one wedge. The sequence must belong to the mesh (isSequenceOf()) and have subset placement; the
/// settings must satisfy checkSettings().
/// Cost: that of the arrangement; *windows* takes some µs a face.
ProgressiveMesh buildProgressiveMesh(const Mesh& mesh, const CollapseSequence& sequence,
                                     const ArrangementSettings& settings = {});

/// Returns the most steps whose distance from the original is at most `tolerance` (units of positions): by
/// the measured errors, or else by the estimates that are kept, which know no kinds.
std::uint32_t stepsToDistance(const ProgressiveMesh& progressive, double tolerance,
                              ErrorKind kind = ErrorKind::maximum);

/// Returns the largest of the estimates up to `steps` steps.
LevelError errorAfter(const ProgressiveMesh& progressive, std::uint32_t steps);

/// Tells whether every step can be played and undone within the arrays, with faces of this mesh at every
/// level.
bool isValid(const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
