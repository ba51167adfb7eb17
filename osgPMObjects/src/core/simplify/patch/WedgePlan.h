// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/Wedge.h>

#include "../star/Star.h"

namespace osgPMObjects::core
{

/// What one wedge of a collapse becomes.
struct WedgeChange
{
    std::uint32_t wedge = 0;
    std::uint32_t becomes = 0; ///< a wedge of the other position; or itself, when it moves there
    Wedge attributes;          ///< of what it becomes, after the step
};

/// The mesh that wedges belong to, as it is now.
struct WedgedMesh
{
    const StarMesh& stars;
    const Mesh& mesh; ///< attributes and materials
    std::span<const glm::dvec3> positions;
};

/// Which wedges of a position become which ones of the other. Wedges collapse as groups: where a face that vanishes
/// has a wedge at either end of the edge, the one becomes the other, so a seam stays a seam.
/// Source: Hoppe, "Efficient implementation of progressive meshes" (1998), §3 (wedges of ecol).
class WedgePlan
{
public:
    /// For moving nothing: every wedge around `star.middle` becomes one of `to`'s. One whose group the edge leads away from becomes
    /// the one that looks most like it.
    void match(const WedgedMesh& all, const Star& star, std::uint32_t to);

    /// For both positions moving to a place: groups that the edge joins become one, others stay; each wedge looks afterwards as
    /// its group does now at the point nearest to the place.
    void resample(const WedgedMesh& all, const Star& star, const Star& other, const glm::dvec3& place);

    std::span<const WedgeChange> ofFrom() const { return _from; }
    std::span<const WedgeChange> ofTo() const { return _to; } ///< empty unless resampled

private:
    std::vector<WedgeChange> _from, _to;
};

} // namespace osgPMObjects::core
