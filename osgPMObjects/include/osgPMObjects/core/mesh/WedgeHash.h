// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

/// Returns a hash of a wedge; equal wedges (operator==) have equal hashes.
inline std::uint64_t hashWedge(const Wedge& w)
{
    std::uint64_t hash = stir(0, w.position);
    for (const float x : {w.normal.x, w.normal.y, w.normal.z, w.texCoords[0].x, w.texCoords[0].y,
                          w.texCoords[1].x, w.texCoords[1].y, w.colour.r, w.colour.g, w.colour.b, w.colour.a})
        hash = stir(hash, bitsOf(x));
    return hash;
}

} // namespace osgPMObjects::core
