// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// How different attributes may be and count as the same. The defaults are below what eight bits a channel show.
struct WedgeTolerance
{
    float normal = 1e-6f;   ///< in each component
    float texCoord = 1e-6f; ///< in each component; 1 is the width of a texture
    float colour = 1e-4f;   ///< in each channel, 0…1
    bool dropUnseen =
        true; ///< also attributes that the material's state does not look at (Material::unseen) go
};

/// What mergeWedges() did.
struct MergedWedges
{
    std::size_t merged = 0;           ///< wedges that were needless
    std::size_t unseenAttributes = 0; ///< attributes dropped, each material and attribute counted once
};

/// Needless splits: wedges on one position, of faces of one material, whose attributes are the same become one. Each joins the
/// first that is the same to the tolerance. Wedges end up in the order of their positions, each used by one material only.
/// Source: spec 3 and the anchors: on real vehicles it gains more than any order.
MergedWedges mergeWedges(Mesh& mesh, const WedgeTolerance& tolerance = {});

/// Removes positions and wedges that no face uses; the order of the others stays.
void compactMesh(Mesh& mesh);

} // namespace osgPMObjects::core
