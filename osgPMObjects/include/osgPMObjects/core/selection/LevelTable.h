// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>
#include <osgPMObjects/core/simplify/ErrorLadder.h>

namespace osgPMObjects::core
{

/// The properties of a model's levels that selection needs; all instances of the model share it. A level is a
/// number of steps of the model's CollapseSequence; 0 is the full mesh. A model with a few discrete levels
/// counts one step between two of them.
/// Invariant: isLevelTable(). Units: the model's positions. Memory: 20 B a step.
struct LevelTable
{
    std::uint32_t positions = 0;      ///< V: positions of the full mesh that its faces use
    double area = 0.0;                ///< S: area of all faces of the full mesh
    std::vector<std::uint32_t> faces; ///< by level: one more entry than there are steps
    std::vector<LevelError> errors;   ///< estimates by level; they never fall; 0 for level 0
    ErrorLadder measured;             ///< if it is not empty, it replaces LevelError::distance in `errors`

    std::uint32_t mostSteps() const { return static_cast<std::uint32_t>(faces.size()) - 1; }
    /// Returns the most steps that leave at least `leastFaces` faces; 0 where the mesh has fewer. Cost:
    /// logarithmic.
    std::uint32_t coarsestWith(std::uint32_t leastFaces) const;

    /// Returns a level's errors; the distance is the measured one of this kind, if there is one. Cost:
    /// logarithmic.
    LevelError errorAfter(std::uint32_t steps, ErrorKind kind) const;

    /// Makes the table of a mesh and its sequence. It ends before the steps that leave no face: objects
    /// vanish by alpha or by culling, not by their level. Cost: linear.
    static LevelTable of(const Mesh& mesh, const CollapseSequence& sequence);
    /// Makes the table of a progressive mesh; `errors` are those of core::errorAfter(). It ends as the table
    /// above.
    /// Cost: that of playing all steps once.
    static LevelTable of(const ProgressiveMesh& progressive);
};

/// Tells whether there is a level, faces never grow and estimates never fall from level to level, level 0 has
/// no estimated error, and measured levels are levels of the table.
bool isLevelTable(const LevelTable& table);

} // namespace osgPMObjects::core
