// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <osgTerrainROAM/core/roam/RoamTile.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace osgTerrainROAM::core
{

/// A tile prepared for one method: what all view groups' meshes share. Each method has a class of its own.
/// Threads: const from any; newMesh(), if the tile is edited, with a shared lock of its mutex.
class PreparedTerrain
{
public:
    virtual ~PreparedTerrain() = default;

    virtual const RoamTile& tile() const = 0;

    /// A mesh for one view group; it shares this. Refine it before it is drawn.
    virtual std::unique_ptr<TerrainMesh> newMesh() const = 0;

    /// The fewest triangles that a mesh can have: no ceiling may be lower.
    virtual std::uint32_t fewestTriangles() const = 0;

    /// What the method stores besides the tile.
    virtual std::size_t memoryBytes() const = 0;

protected:
    PreparedTerrain() = default;
    PreparedTerrain(const PreparedTerrain&) = default;
    PreparedTerrain& operator=(const PreparedTerrain&) = default;
};

using PreparedPtr = std::shared_ptr<const PreparedTerrain>;

} // namespace osgTerrainROAM::core
