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

/// What a wedge of the position that goes becomes.
struct WedgeCollapse
{
    std::uint32_t from = 0; ///< a wedge of the position that goes
    std::uint32_t to = 0;   ///< a wedge of the position that stays

    bool operator==(const WedgeCollapse&) const = default;
};

/// How far a level is from the original, as far as the collapses know: along each chain of collapses what every removed vertex
/// is away from the faces that took its place, summed up.
struct LevelError
{
    float distance = 0.0f; ///< units as the positions (metres in a trainer's models)
    float normal = 0.0f;   ///< difference of unit normals, 0…2
    float texCoord = 0.0f; ///< drift of the texture, 1 is its width
    float colour = 0.0f;   ///< difference in the channel that differs most, 0…1

    bool operator==(const LevelError&) const = default;
};

/// One step: a position goes into another. Faces that have both vanish; the others keep their number and get the other wedges.
struct CollapseStep
{
    std::uint32_t from = 0;       ///< the position that goes
    std::uint32_t to = 0;         ///< the position that stays
    std::uint32_t firstWedge = 0; ///< in CollapseSequence::wedges, up to the next step's
    std::uint32_t firstMoved = 0; ///< in CollapseSequence::movedWedges, up to the next step's
    std::uint32_t facesAfter = 0; ///< how many faces are left after the step
    /// The next step belongs to this one, as the second of two mirrored steps or as the growth of a leaf for one that has gone: a level between
    /// them is sound, but lopsided or thin.
    bool goesOn = false;
    LevelError error; ///< of the surface after the step; in nothing less than that of the step before
};

/// A wedge that a step gives other attributes, and perhaps another position.
struct MovedWedge
{
    std::uint32_t wedge = 0;
    Wedge attributes;
};

/// A mesh's way from all of its faces to none, one position a step: every level in between is a prefix of it.
/// With *subset* placement positions and wedges stay what they are. With *optimal* placement a step also moves the position that
/// stays (`places`, by step) and gives its wedges new attributes (`movedWedges`).
/// Faces that use a position twice are no faces, before and after.
/// Invariant: isSequenceOf(). Memory: 40 B a step, 8 B a wedge that goes; optimal: 24 B a step and the moved wedges besides.
/// Source: Hoppe, "Progressive meshes" (1996), §3 (ecol and vsplit); stored from the finest level down, for that is how
/// levels of a mesh in memory are made.
struct CollapseSequence
{
    std::uint32_t facesBefore = 0; ///< how many faces there are before the first step
    std::vector<CollapseStep> steps;
    std::vector<WedgeCollapse> wedges;
    std::vector<glm::dvec3> places; ///< by step, or empty: where `to` is after the step
    std::vector<MovedWedge> movedWedges;

    std::span<const WedgeCollapse> wedgesOf(std::size_t step) const;
    std::span<const MovedWedge> movedWedgesOf(std::size_t step) const;
};

/// How many steps lead to a level of at most `faces` faces. Does not stop between steps that belong together, unless the rest of them would
/// lead more than a tenth below.
std::size_t stepsToFaces(const CollapseSequence& sequence, std::size_t faces);

/// How many steps can be made without the distance going above a tolerance. Units: as the positions.
std::size_t stepsToDistance(const CollapseSequence& sequence, double tolerance);

/// The level after some steps, with only the positions and wedges its faces use; materials and parts stay all, faces in
/// their order. Cost: linear in the mesh.
Mesh meshAfter(const Mesh& mesh, const CollapseSequence& sequence, std::size_t steps);

/// Whether the sequence can be played on the mesh: the positions of every step are there and not gone before, every
/// wedge in use of a position that goes becomes one of the other's, face counts are as told, errors never fall.
bool isSequenceOf(const CollapseSequence& sequence, const Mesh& mesh);

} // namespace osgPMObjects::core
