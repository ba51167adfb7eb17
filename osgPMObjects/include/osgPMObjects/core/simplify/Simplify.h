// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// Where a collapse puts the remaining position, and which error it minimises.
enum class Placement
{
    subset,  ///< at one of the two: all levels are drawn from the original's vertices
    optimal, ///< at the least quadric error that keeps the volume; weighs the largest error, too
    quality, ///< the same for the mean error alone; slender features may be lost
};

/// Which planes the cost of a collapse looks at.
enum class Quadrics
{
    memoryless,  ///< those of the faces around both positions as they are now
    accumulated, ///< those of all faces that were ever around what has merged into them
};

/// Settings of simplify().
struct SimplifySettings
{
    Placement placement = Placement::subset;
    /// Accumulated ones know how far a place is from the original surface, but count a plane as often as it
    /// has been added.
    Quadrics quadrics = Quadrics::memoryless;
    /// Also weigh appearance: borders of materials, texture coordinates, normals and colours.
    bool keepSeams = true;
    /// Texture drift, in widths of the texture, beyond which it costs as much as a displacement of the
    /// surface by the same way, at most by two hundredths of the diagonal.
    float mostTexCoordDrift = 2.0f / 1024.0f;
    /// Keep a mesh mirror-symmetric when it is so across the middle of its box: collapses are then done in
    /// pairs.
    bool keepSymmetry = true;
    /// Above 0: connected parts may join over gaps up to this distance: a position may merge into the nearest
    /// one of another part.
    /// Units: as the positions.
    double joinDistance = 0.0;
    /// With joinDistance: so may positions of one part, if the way between them along its edges is more than
    /// three times as long as that distance: slits, the gaps between blades, sheets over each other.
    bool joinWithinParts = false;
    /// Enlarge remaining leaf cards as others are removed, so that foliage keeps its area. Only for materials
    /// of foliage: very many small flat parts of all directions. Not with an envelope or joinDistance, nor
    /// for a mesh that is kept symmetric.
    bool growLeaves = true;
    /// Above 0: at every level the surface is within this distance of the original, and the original within
    /// this distance of it. This is proved for whole triangles, not sampled. The sequence ends when no
    /// collapse keeps the bound; no part vanishes, and no face turns over. Units: as the positions. Takes
    /// some twenty times as long.
    double envelope = 0.0;
    /// The mesh is a height field: a face that turns over in plan (seen along z) counts as one that turns
    /// over.
    bool isHeightField = false;
    /// By position: whether it is never removed; empty: none is. Its neighbours may merge into it. With
    /// subset placement only. The sequence ends when no other position is left.
    std::vector<bool> locked = {};
    /// By position: the straight lines in plan on which it lies, a bit for each; empty: none. It merges only
    /// into positions on all of these lines, so ends and crossings of lines stay; and a face between three
    /// positions of one line counts as one that turns over. So an outline of straight sides keeps its shape
    /// in plan. With subset placement only.
    std::vector<std::uint8_t> lines = {};
    /// By material: its mean colour, 0 to 1, as it is seen from far away (osgPMObjects::materialColours());
    /// empty: unknown. A material that looks like one of larger area is given up the earlier, the less they
    /// differ.
    std::vector<glm::vec3> materialColours = {};
};

/// Computes the sequence of edge collapses of a mesh, from all of its faces to none.
/// The mesh must be valid (MeshCheck.h). It should be consolidated and have no two positions at one point
/// (weldPositions() with a tolerance of 0), since such positions are not connected. Any other set of faces is
/// allowed: non-manifold or open edges, parts of one face. When every remaining collapse turns a face over,
/// the least harmful one is done; parts that are smaller than the error vanish. No position leaves the box of
/// the mesh. With optimal placement the area that a collapse takes or adds has a cost, so that levels of few
/// faces keep their silhouettes. The last face of a material is removed at the cost of a distance of half the
/// diagonal, times its contrast to the most similar larger material, for all the area that the material had.
/// Deterministic: the same for any number of threads.
/// Memory: some 330 B a position besides the mesh, 650 B with moved positions. Cost: see
/// docs/measurements/simplification.md.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997); Lindstrom and
/// Turk, *Fast and memory efficient polygonal simplification* (1998); Hoppe, *Progressive meshes* (1996) and
/// *Efficient implementation of progressive meshes* (1998). The headers in src/core/simplify name the
/// sections and the differences.
CollapseSequence simplify(const Mesh& mesh, const SimplifySettings& settings = {});

} // namespace osgPMObjects::core
