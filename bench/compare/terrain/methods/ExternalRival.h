// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "compare/terrain/methods/Rival.h"

namespace terraintool
{

/// A program that makes one mesh of a whole terrain.
struct ExternalMethod
{
    std::string name;    ///< of its row
    std::string command; ///< of the shell; five arguments follow it
};

/// Makes a row of a program that this project does not have. It is called with the arguments HEIGHTS COLUMNS
/// ROWS ERROR MESH: a file of heights (float, of this machine's byte order, in metres, row by row from the
/// south, each from the west), the numbers of columns and rows, an error in metres that it may mean as it
/// likes, and the OBJ file to write: a vertex `v column row height` is a sample, and all faces are
/// counter-clockwise seen from above. Its mesh is the same for all eyes, and its tolerance is that error:
/// where the other methods have pixels, it has metres. Calls one program at a time. `preparationS` of a mesh:
/// processor time of the program at that error.
/// Errors: the program fails, or writes no such mesh. Those of later calls: Rival::failure.
/// Precondition: a planar tile without holes.
foundation::Result<Rival> externalRival(const ExternalMethod& method,
                                        const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

} // namespace terraintool
