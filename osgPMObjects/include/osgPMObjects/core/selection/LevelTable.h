// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// What the rules of selection know of a model, shared by all its instances. A level is a number of steps of its
/// CollapseSequence, 0 being the full mesh: the one count that every rule can name to the position and every progressive mesh
/// can be set to. A model of a few discrete levels has one step between two of them.
/// Invariant: isLevelTable(). Units: the model's positions. Memory: 20 B a step.
struct LevelTable
{
    std::uint32_t positions = 0;      ///< V: those of the full mesh that its faces use
    double area = 0.0;                ///< S: of all faces of the full mesh
    std::vector<std::uint32_t> faces; ///< by level, one more than there are steps
    std::vector<LevelError> errors;   ///< by level; that of level 0 is 0

    std::uint32_t mostSteps() const { return static_cast<std::uint32_t>(faces.size()) - 1; }
    /// The most steps that leave so many faces; 0 where the mesh has fewer. Cost: logarithmic.
    std::uint32_t coarsestWith(std::uint32_t leastFaces) const;

    /// Of a mesh and a sequence of it. Steps after which no face is left are not counted in: what has to vanish, vanishes by
    /// alpha or by its culling, not by its level. Cost: linear.
    static LevelTable of(const Mesh& mesh, const CollapseSequence& sequence);
    /// Of a progressive mesh, which keeps upper bounds of its errors only (errorAfter()). The same levels are left out.
    /// Cost: that of playing all steps once.
    static LevelTable of(const ProgressiveMesh& progressive);
};

/// Whether there is a level, faces never grow and errors never fall from one to the next, and level 0 has no error.
bool isLevelTable(const LevelTable& table);

} // namespace osgPMObjects::core
