// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>
#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

/// Returns removals as edge collapses with subset placement, which buildProgressiveMesh() takes: each removed
/// position merges into its apex, and every level has the faces of the same level of the removals. The number
/// of steps is the number T of removed positions in the formula of Sadykov & Zakharov (2002), section 5.
/// Differs: a part that is removed as a whole shrinks edge by edge, so its faces differ from those of the
/// removals until all are gone, and its last position, without faces, takes no step.
/// `removals`: a sequence of the mesh made with HoleTriangulation::fan. Cost: linear.
/// Source: Hoppe, *Progressive meshes* (1996), section 3 (edge collapse): removing a position and filling the
/// hole by a fan is one.
CollapseSequence collapsesOf(const Mesh& mesh, const RemovalSequence& removals);

} // namespace osgPMObjects::core
