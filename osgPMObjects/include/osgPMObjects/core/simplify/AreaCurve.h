// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

/// The mesh as a shape alone: a wedge for each position, without attributes, one material, one part. Positions keep their numbers.
Mesh shapeOf(const Mesh& mesh);

/// Area against faces, level by level.
/// Source: paper 004, §4 and figure 14.
struct AreaCurve
{
    std::vector<std::size_t> faces; ///< after 0, 1, … steps: never rises
    std::vector<double> areas;      ///< by the same; of what is left. Units: of the positions, squared

    /// How far the area is from that of the mesh, as a share of it: the mean of |A(F) / A(all) - 1| over numbers of faces F that
    /// are spread evenly in their logarithm from `fewest` to all; of the first level that has no more than F.
    double meanDeviation(std::size_t fewest) const;

    /// The first level with no more faces than that; the last one when there is none.
    std::size_t levelOf(std::size_t count) const;
};

/// Cost: linear in what the sequence stores.
AreaCurve areaCurve(const Mesh& mesh, const RemovalSequence& sequence);

} // namespace osgPMObjects::core
