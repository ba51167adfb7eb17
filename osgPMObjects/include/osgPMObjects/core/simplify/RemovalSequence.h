// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Why a position cannot be removed as things stand.
enum class RemovalRefusal : std::uint8_t
{
    none,
    support,        ///< it is one that has to stay
    crowdedStar,    ///< more faces around it than kMostStarFaces
    nonManifold,    ///< its faces are no fans: an edge with more than two, or two that disagree
    seamCorner,     ///< a seam or border of materials ends or branches there
    folds,          ///< the hole's contour crosses itself, or its faces would be turned over
    joins,          ///< an edge or a face would be there that is already
    isolates,       ///< a neighbour would be left without a face
    lastOfMaterial, ///< no face would have the material any more
};

constexpr std::size_t kRemovalRefusals = 9;
const char* nameOf(RemovalRefusal refusal);

/// One position goes with all its faces, others fill the hole.
struct RemovalStep
{
    std::uint32_t position = 0;
    std::uint32_t firstRemoved = 0; ///< in RemovalSequence::removedFaces; up to the next step's
    std::uint32_t firstAdded = 0;   ///< in RemovalSequence::addedFaces; up to the next step's
    bool isOfPart = false; ///< a whole group of faces goes, position by position: nothing fills the hole
    double error = 0.0;    ///< never less than the step's before; see removeVertices()
};

/// All levels of a mesh from all its positions down to what cannot be removed, one position a step.
/// Faces are numbered: those of the mesh, then the added ones. Faces of every level use wedges of the mesh.
/// Invariant: removalDefectOf() finds none. Units: as the positions. Memory: some 140 B a step.
struct RemovalSequence
{
    std::size_t positionCount = 0; ///< that the mesh's faces use
    std::size_t faceCount = 0;     ///< of the mesh
    std::vector<RemovalStep> steps;
    std::vector<std::uint32_t> removedFaces; ///< by number, step by step
    std::vector<Face> addedFaces;            ///< step by step
    /// Positions that are left at the end, by why they cannot go.
    std::array<std::size_t, kRemovalRefusals> left{};

    std::span<const std::uint32_t> removedBy(std::size_t step) const;
    std::span<const Face> addedBy(std::size_t step) const;

    /// How many faces there are after so many steps.
    std::size_t facesAfter(std::size_t steps) const;

    /// The fewest steps after which there are at most so many faces; all of them if there never are.
    std::size_t stepsToFaces(std::size_t faces) const;
};

/// A level, and whether it is the one that was asked for.
struct RemovalLevel
{
    Mesh mesh;
    std::size_t removed = 0; ///< positions
    bool isClamped = false;  ///< more were asked for than can be removed
};

/// The mesh without the first `removals` positions of the sequence. Positions and wedges stay where they are, used or not; of
/// the faces those that are left keep their order, added ones follow. Cost: linear.
RemovalLevel meshAfter(const Mesh& mesh, const RemovalSequence& sequence, std::size_t removals);

/// What keeps a sequence from being one of the mesh; empty: nothing does. Each step has to remove one position that is there with
/// exactly its faces, and to add faces that fill the hole and nothing else: with the contour's sides, one side more for each
/// contour that was open, wedges, materials and parts of the faces that went; no edge may get a second face that runs along
/// it the same way. Errors must not decrease. Steps that remove a part must leave nothing of it. Cost: linear in what is stored.
std::string removalDefectOf(const RemovalSequence& sequence, const Mesh& mesh);

inline bool isSequenceOf(const RemovalSequence& sequence, const Mesh& mesh)
{
    return removalDefectOf(sequence, mesh).empty();
}

} // namespace osgPMObjects::core
