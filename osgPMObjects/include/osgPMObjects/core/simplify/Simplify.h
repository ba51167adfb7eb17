// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// Where the position that two become is put, and by which error.
enum class Placement
{
    subset,  ///< at one of the two: all levels are drawn from the original's vertices
    optimal, ///< where the distances are least and the volume is kept; the largest error counts, too
    quality, ///< the same for the least mean error, whatever becomes of slender features
};

/// What may be given up for fewer faces.
struct SimplifySettings
{
    Placement placement = Placement::subset;
    /// Whether what is seen counts besides the shape: borders of materials, texture coordinates, normals and colours.
    bool keepSeams = true;
    /// Drift of the texture, 1 being its width, that is avoided as if the surface were off by two hundredths of the diagonal.
    float mostTexCoordDrift = 2.0f / 1024.0f;
    /// Whether a mesh that is its own mirror image across the middle of its box stays that: collapses are then done in pairs.
    bool keepSymmetry = true;
    /// Above 0: parts no farther apart than this may join: a position may go into the nearest of another part as into a neighbour.
    /// Units: as the positions.
    double joinDistance = 0.0;
    /// Whether leaf cards that are left grow as others go, so that foliage keeps its area. Only where a material is foliage: very many small
    /// flat parts that look in all directions. Not within an envelope, nor of a mesh that stays its own mirror image, nor where parts join.
    bool growLeaves = true;
    /// Above 0: the surface stays within this distance of the original, and the original within this distance of it, at every level;
    /// proved for whole triangles, not sampled. The sequence then ends where no collapse keeps the promise; no part vanishes, and
    /// no face turns over. Units: as the positions. Takes some twenty times as long.
    double envelope = 0.0;
};

/// The sequence of collapses of a mesh, from all of its faces to none.
/// The mesh has to be valid (MeshCheck.h) and should be consolidated, with positions at one place joined (weldPositions() with
/// a tolerance of 0): those that are not part from each other. Otherwise any set of faces will do: non-manifold edges, open
/// ones, parts of one face. It does not get stuck: when every collapse that is left turns a face over, the least bad is
/// done, and parts that are smaller than the error vanish. No place leaves the box of the mesh.
/// The last face of every material goes late: as if the whole surface were off by a twentieth of the diagonal.
/// Deterministic: the same for any number of threads.
/// Memory: some 330 B a position besides the mesh, 650 B when places are found. Cost: see docs/algorithms/simplification.md.
/// Source: Garland and Heckbert (1997), Lindstrom and Turk (1998), Hoppe (1996, 1998); which parts of them, and where ours
/// differs, say the headers in src/core/simplify.
CollapseSequence simplify(const Mesh& mesh, const SimplifySettings& settings = {});

} // namespace osgPMObjects::core
