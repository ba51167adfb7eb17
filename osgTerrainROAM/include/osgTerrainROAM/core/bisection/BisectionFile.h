// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/bisection/BisectionModel.h>

namespace osgTerrainROAM::core
{

/// What a .bisection file says: lines key = value, as in a .roam file (docs/reference/bisection-file.md).
/// Units: metres, or those of the mesh.
struct BisectionFile
{
    std::filesystem::path mesh; ///< of coarse faces; empty: `dem`, or else the cube from -1 to 1
    std::filesystem::path dem;  ///< the mesh is squares, with the heights of this raster
    int levels = 0;             ///< of the finest triangles; 0: what the raster has, or 12
    double radius = 0.0;        ///< points lie this far from the origin; 0: where the mesh has them
    double relief = 0.0;        ///< greatest height of made-up relief
    double reliefSize = 1.0;    ///< of its largest bumps
    std::vector<std::filesystem::path>
        tins; ///< files of triangles; each becomes a TIN in the triangle that holds it

    bool operator==(const BisectionFile&) const = default;
};

/// `name`: for messages, and for paths, which are relative to its folder. Errors: a line that is none, an
/// unknown key, a value out of range; keys that do not go together.
foundation::Result<BisectionFile> parseBisectionFile(std::string_view text,
                                                     const std::filesystem::path& name);

/// Reads a .bisection file and all that it names. Errors: of the file, of those that it names, more than 2^22
/// finest triangles, a TIN that lies in no triangle, or in that of another.
/// Cost and memory: those of the complete bintrees.
foundation::Result<std::shared_ptr<const BisectionModel>> openBisection(const std::filesystem::path& file);

} // namespace osgTerrainROAM::core
