// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The largest difference of attributes that count as equal. The defaults are below the resolution of 8-bit
/// channels.
struct WedgeTolerance
{
    float normal = 1e-6f;   ///< in each component
    float texCoord = 1e-6f; ///< in each component; 1 is the width of a texture
    float colour = 1e-4f;   ///< in each channel, 0…1
    bool dropUnseen =
        true; ///< also drop attributes that the material's state does not use (Material::unseen)
};

/// Report of mergeWedges().
struct MergedWedges
{
    std::size_t merged = 0;           ///< wedges removed
    std::size_t unseenAttributes = 0; ///< attributes dropped, counted once for each material and attribute
};

/// Removes needless attribute splits: wedges of one position and one material with equal attributes become
/// one, the first that is equal to the tolerance. The result has wedges in the order of their positions, each
/// used by one material only. On real vehicles this saves more vertex work than any order of faces.
MergedWedges mergeWedges(Mesh& mesh, const WedgeTolerance& tolerance = {});

/// Removes positions and wedges that no face uses; the others keep their order.
void compactMesh(Mesh& mesh);

} // namespace osgPMObjects::core
