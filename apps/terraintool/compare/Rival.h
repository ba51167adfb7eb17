// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <viewlod/Budget.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace terraintool
{

/// The mesh of one method, as the comparison sees it.
class RivalMesh
{
public:
    virtual ~RivalMesh() = default;

    virtual osgTerrainROAM::core::RefineResult refine(const viewlod::ViewState& view,
                                                      const viewlod::Budget& budget) = 0;
    virtual osgTerrainROAM::core::DrawnMesh drawn() const = 0;

    /// Vertices that a card transforms for each triangle (batches of 32 triangles). Nothing where triangles do not share vertices.
    virtual std::optional<double> transformsPerTriangle() const = 0;

    virtual bool isValid() const = 0;

    /// Without what the meshes of a tile share.
    virtual std::size_t memoryBytes() const = 0;
};

/// One of the methods that are compared, prepared for a terrain.
struct Rival
{
    std::string name;
    bool isOfBlocks = false; ///< chooses the detail of whole blocks
    double fewestTriangles = 2.0;
    bool keepsCeiling = true;    ///< takes a number of triangles in advance
    bool stopsInTime = false;    ///< takes a limit of time
    double preparationS = 0.0;   ///< processor time of all threads, that of the tile included
    std::size_t sharedBytes = 0; ///< what all meshes share besides the tile
    std::function<std::unique_ptr<RivalMesh>()> newMesh;
};

/// The terrain and all methods, with ROAM from scratch ("scratch") as the last.
struct Rivals
{
    std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile;
    std::vector<Rival> all;
};

/// Prepares a square of samples, on a plane, for every method (osgTerrainROAM::core::kMethods).
/// Errors: a method cannot draw it.
foundation::Result<Rivals> prepareRivals(const osgTerrainROAM::core::HeightField& square);

} // namespace terraintool
