// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <viewlod/Budget.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/method/Method.h>
#include <osgTerrainROAM/core/roam/LeafOrder.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/PreparedTerrain.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace terraintool
{

/// How much a refinement wrote.
struct WrittenSlots
{
    std::size_t triangles = 0, vertices = 0;
};

/// The mesh of one method, as the comparison sees it.
class RivalMesh
{
public:
    virtual ~RivalMesh() = default;

    virtual osgTerrainROAM::core::RefineResult refine(const viewlod::ViewState& view,
                                                      const viewlod::Budget& budget) = 0;
    virtual osgTerrainROAM::core::DrawnMesh drawn() const = 0;

    /// How the triangles lie. Nothing where they do not share vertices.
    virtual std::optional<osgTerrainROAM::core::LeafOrder> order() const = 0;

    /// Lets detail come and go without a jump from the next refinement on. Returns whether the method does.
    virtual bool setMorphing(bool) { return false; }

    /// Slots of triangles and vertices that the last refinement wrote; of a mesh that is made anew all of
    /// them.
    virtual WrittenSlots written() const = 0;

    /// Triangles that are left when those are omitted that cannot be in the frame. Nothing: the method omits
    /// none.
    virtual std::optional<std::uint32_t> trianglesIn(const viewlod::Frustum&) const { return std::nullopt; }

    virtual bool isValid() const = 0;

    /// Without what the meshes of a tile share.
    virtual std::size_t memoryBytes() const = 0;

    /// Processor time that this mesh has cost besides Rival::preparationS.
    virtual double preparationS() const { return 0.0; }
};

/// One of the methods that are compared, prepared for a terrain.
struct Rival
{
    std::string name;
    bool isOfBlocks = false; ///< chooses the detail of whole blocks
    double fewestTriangles = 2.0;
    bool adapts = true;       ///< to the eye; else its mesh depends on the tolerance alone
    bool keepsCeiling = true; ///< takes a number of triangles in advance
    bool stopsInTime = false; ///< takes a limit of time
    std::optional<osgTerrainROAM::core::Method>
        drawnBy{}; ///< what RoamDrawable calls it; nothing: it draws no such mesh
    osgTerrainROAM::core::PreparedPtr prepared{}; ///< by that method
    double preparationS = 0.0;   ///< processor time of all threads, that of the tile included
    std::size_t sharedBytes = 0; ///< what all meshes share besides the tile
    std::size_t parts = 1;       ///< of what is prepared: those that are whole without the others
    std::function<std::unique_ptr<RivalMesh>()> newMesh;
    std::function<std::optional<foundation::Error>()>
        failure{}; ///< tells what has kept it from making a mesh; empty: nothing can
};

/// The terrain and all methods, ROAM by the paper's own loop ("roam-walk") and by Duchaineau's two queues
/// ("roam-queue") among them, then split multi-triangulations ("multi-triangulation") and ROAM from scratch
/// ("scratch").
struct Rivals
{
    std::shared_ptr<osgTerrainROAM::core::RoamTile> tile;
    std::vector<Rival> all;
};

/// Prepares a square of samples, on a plane, for every method (osgTerrainROAM::core::kMethods).
/// Errors: a method cannot draw it.
foundation::Result<Rivals> prepareRivals(const osgTerrainROAM::core::HeightField& square);

} // namespace terraintool
