// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

/// Returns the shape of a mesh: one wedge for each position, no attributes, one material, one part. Positions
/// keep their numbers.
Mesh shapeOf(const Mesh& mesh);

/// The surface area of each level of a removal sequence, with its number of faces.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 4, figure 14.
struct AreaCurve
{
    std::vector<std::size_t> faces; ///< by number of steps, 0 to all; never rises
    std::vector<double> areas;      ///< by number of steps; units: of the positions, squared

    /// The mean of |A(F) / A(all) - 1| over numbers of faces F from `fewest` to all, evenly spaced on a
    /// logarithmic scale. A(F) is the area of the first level that has at most F faces.
    double meanDeviation(std::size_t fewest) const;

    /// The first level with at most `count` faces; the last level where there is none.
    std::size_t levelOf(std::size_t count) const;
};

/// Computes the area curve of a sequence of the mesh. Cost: linear in what the sequence stores.
AreaCurve areaCurve(const Mesh& mesh, const RemovalSequence& sequence);

} // namespace osgPMObjects::core
