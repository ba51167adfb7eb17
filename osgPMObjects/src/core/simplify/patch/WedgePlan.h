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

/// The change of one wedge in a collapse.
struct WedgeChange
{
    std::uint32_t wedge = 0;
    std::uint32_t becomes = 0; ///< a wedge of the other position; or itself, when it moves there
    Wedge attributes;          ///< of `becomes`, after the step
};

/// The wedges of the current mesh, with their faces and attributes.
struct WedgedMesh
{
    const StarMesh& stars;
    const Mesh& mesh; ///< attributes and materials
    std::span<const glm::dvec3> positions;
};

/// Plans which wedges of a position become which of the other. Wedges collapse as groups: where a vanishing
/// face has a wedge at either end of the edge, one becomes the other, so a seam remains a seam.
/// Source: Hoppe, *Efficient implementation of progressive meshes* (1998), section 3 (wedges of ecol).
class WedgePlan
{
public:
    /// Plans a collapse that moves nothing: every wedge around `star.middle` becomes one of `to`. A wedge
    /// without a partner across the edge becomes the most similar one.
    void match(const WedgedMesh& all, const Star& star, std::uint32_t to);

    /// Plans a collapse that moves both positions to `place`: groups connected by the edge become one, others
    /// remain. Each wedge gets the attributes that its group has now at the nearest point.
    void resample(const WedgedMesh& all, const Star& star, const Star& other, const glm::dvec3& place);

    std::span<const WedgeChange> ofFrom() const { return _from; }
    std::span<const WedgeChange> ofTo() const { return _to; } ///< empty unless resampled

private:
    std::vector<WedgeChange> _from, _to;
};

} // namespace osgPMObjects::core
