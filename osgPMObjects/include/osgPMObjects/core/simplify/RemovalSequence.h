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

/// The reason why a position cannot be removed now.
enum class RemovalRefusal : std::uint8_t
{
    none,
    support,        ///< it is a support vertex
    crowdedStar,    ///< more faces around it than kMostStarFaces
    nonManifold,    ///< an edge has more than two faces, or two of opposite orientation
    seamCorner,     ///< a seam or a border of materials ends or branches at the position
    folds,          ///< the contour of the hole crosses itself, or a new face would be turned over
    joins,          ///< a new edge or face exists already
    isolates,       ///< a neighbour would lose its last face
    lastOfMaterial, ///< a material would lose its last face
};

constexpr std::size_t kRemovalRefusals = 9;
const char* nameOf(RemovalRefusal refusal);

/// One removal: a position is removed with all its faces, and new faces fill the hole.
struct RemovalStep
{
    static constexpr std::uint32_t kNoApex = ~0u;

    std::uint32_t position = 0;
    std::uint32_t firstRemoved = 0; ///< the first in RemovalSequence::removedFaces; the next step's follow
    std::uint32_t firstAdded = 0;   ///< the first in RemovalSequence::addedFaces; the next step's follow
    bool isOfPart =
        false; ///< a connected group of faces is removed, position by position; no faces fill its holes
    double error = 0.0;           ///< never less than at the step before; see removeVertices()
    std::uint32_t apex = kNoApex; ///< HoleTriangulation::fan: the position at which all added faces meet
};

/// A mesh's levels of detail as vertex removals, one position a step, until no position can be removed.
/// Faces are numbered: those of the mesh first, then the added ones. Faces of every level use wedges of the
/// mesh.
/// Invariant: removalDefectOf() is empty. Units: as the positions. Memory: some 140 B a step.
struct RemovalSequence
{
    std::size_t positionCount = 0; ///< number of positions that the mesh's faces use
    std::size_t faceCount = 0;     ///< number of faces of the mesh
    std::vector<RemovalStep> steps;
    std::vector<std::uint32_t> removedFaces; ///< by step: face numbers
    std::vector<Face> addedFaces;            ///< by step
    /// Number of remaining positions at the end, by the reason why they cannot be removed.
    std::array<std::size_t, kRemovalRefusals> left{};

    std::span<const std::uint32_t> removedBy(std::size_t step) const;
    std::span<const Face> addedBy(std::size_t step) const;

    /// Number of faces after `steps` steps.
    std::size_t facesAfter(std::size_t steps) const;

    /// The fewest steps after which there are at most `faces` faces; all steps where that is never so.
    std::size_t stepsToFaces(std::size_t faces) const;
};

/// A level of detail made by removals.
struct RemovalLevel
{
    Mesh mesh;
    std::size_t removed = 0; ///< number of removed positions
    bool isClamped = false;  ///< fewer were removed than asked for, since no more can be
};

/// Returns the mesh without the first `removals` positions of the sequence. Positions and wedges keep their
/// numbers, used or not. Remaining faces keep their order; added ones follow. Cost: linear.
RemovalLevel meshAfter(const Mesh& mesh, const RemovalSequence& sequence, std::size_t removals);

/// Checks that a sequence fits the mesh; returns a description of the first defect, or an empty string. Each
/// step must remove one existing position with exactly its faces, and add faces that fill the hole and
/// nothing else: with the sides of its contour, one more side for each open contour, and wedges, materials
/// and parts of the removed faces. No edge may get two faces of one direction. Errors must not decrease.
/// Steps that remove a part must remove all of it. Cost: linear in what is stored.
std::string removalDefectOf(const RemovalSequence& sequence, const Mesh& mesh);

inline bool isSequenceOf(const RemovalSequence& sequence, const Mesh& mesh)
{
    return removalDefectOf(sequence, mesh).empty();
}

} // namespace osgPMObjects::core
