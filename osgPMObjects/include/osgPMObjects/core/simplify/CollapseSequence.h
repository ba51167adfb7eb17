// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

/// A wedge of the removed position, and the wedge that replaces it.
struct WedgeCollapse
{
    std::uint32_t from = 0; ///< a wedge of the removed position
    std::uint32_t to = 0;   ///< a wedge of the remaining position

    bool operator==(const WedgeCollapse&) const = default;
};

/// An estimate of how far a level is from the original. Each collapse adds the distance between the removed
/// vertex and the faces that replace its faces to the error of the vertices that were merged into it before.
struct LevelError
{
    float distance = 0.0f; ///< units as the positions (metres in a trainer's models)
    float normal = 0.0f;   ///< difference of unit normals, 0…2
    float texCoord = 0.0f; ///< drift of the texture, 1 is its width
    float colour = 0.0f;   ///< difference in the channel that differs most, 0…1

    bool operator==(const LevelError&) const = default;
};

/// One edge collapse: a position merges into another. Faces with both vanish; the others keep their numbers
/// and get other wedges.
struct CollapseStep
{
    std::uint32_t from = 0;       ///< the removed position
    std::uint32_t to = 0;         ///< the remaining position
    std::uint32_t firstWedge = 0; ///< the first in CollapseSequence::wedges; the next step's follow
    std::uint32_t firstMoved = 0; ///< the first in CollapseSequence::movedWedges; the next step's follow
    std::uint32_t facesAfter = 0; ///< number of faces after the step
    /// The next step belongs to this one: it is the mirror image of this step, or grows a leaf that replaces
    /// removed ones. The level between the two is valid, but asymmetric, or has too little foliage.
    bool goesOn = false;
    LevelError error; ///< of the surface after the step; never less than at the step before
};

/// A wedge that gets other attributes in a step, and perhaps another position.
struct MovedWedge
{
    std::uint32_t wedge = 0;
    Wedge attributes;
};

/// A progressive mesh as its edge collapses: from all faces of a mesh to none, one position a step. A level
/// is the mesh after the first n steps. With *subset* placement, positions and wedges do not change. With
/// *optimal* placement, a step also moves the remaining position (`places`) and gives its wedges new
/// attributes (`movedWedges`). Faces that use a position twice do not count, in the mesh and in all levels.
/// Invariant: isSequenceOf(). Memory: 40 B a step, 8 B a removed wedge; optimal: 24 B a step and the moved
/// wedges besides.
/// Source: Hoppe, *Progressive meshes* (1996), section 3 (edge collapse and vertex split). Differs: stored
/// from the finest level to the coarsest, the order in which levels of a mesh in memory are made.
struct CollapseSequence
{
    std::uint32_t facesBefore = 0; ///< number of faces before the first step
    std::vector<CollapseStep> steps;
    std::vector<WedgeCollapse> wedges;
    std::vector<glm::dvec3>
        places; ///< by step, or empty: the remaining position after the step, in the mesh's frame
    std::vector<MovedWedge> movedWedges;

    std::span<const WedgeCollapse> wedgesOf(std::size_t step) const;
    std::span<const MovedWedge> movedWedgesOf(std::size_t step) const;
};

/// Returns the number of steps to the first level with at most `faces` faces. Steps that belong together
/// (`goesOn`) are not separated, unless the rest of them would remove more than a tenth of the faces.
std::size_t stepsToFaces(const CollapseSequence& sequence, std::size_t faces);

/// Returns the most steps with a distance error of at most `tolerance`. Units: as the positions.
std::size_t stepsToDistance(const CollapseSequence& sequence, double tolerance);

/// Returns the level after `steps` steps, with only the positions and wedges that its faces use. All
/// materials and parts are kept, and faces keep their order. Cost: linear in the mesh.
Mesh meshAfter(const Mesh& mesh, const CollapseSequence& sequence, std::size_t steps);

/// Whether the sequence fits the mesh: both positions of every step exist at that step, every used wedge of a
/// removed position has a replacement at the remaining position, face counts are right, and errors never
/// decrease.
bool isSequenceOf(const CollapseSequence& sequence, const Mesh& mesh);

} // namespace osgPMObjects::core
