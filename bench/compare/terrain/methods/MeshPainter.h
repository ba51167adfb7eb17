// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <foundation/Result.h>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/method/Method.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/PreparedTerrain.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace terraintool
{

/// A terrain as a method has prepared it.
struct PaintedTerrain
{
    std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile;
    osgTerrainROAM::core::Method method;
    osgTerrainROAM::core::PreparedPtr prepared;
};

/// Draws terrains for the comparison. Views: symmetric perspective, as MeshPainter's user flew them.
class MeshPainter
{
public:
    virtual ~MeshPainter() = default;

    /// What draws, in a line.
    virtual std::string rendererName() const = 0;

    /// Draws the terrain by a method as programs draw it, at every view in turn, and returns the median of
    /// what a picture takes: to adapt, to upload, to draw it with the land's full look and to read it. Units:
    /// milliseconds of processor time of all threads. The first two views do not count: they build the mesh
    /// and compile. Errors: the method cannot draw it.
    virtual foundation::Result<double> pictureMs(const PaintedTerrain& terrain, double tolerancePx,
                                                 std::span<const viewlod::ViewState> views) = 0;

    /// Writes a JPEG file of a mesh from one eye: lit triangles above, with their sides below. Errors: the
    /// file cannot be written.
    virtual foundation::Outcome write(const osgTerrainROAM::core::DrawnMesh& mesh,
                                      const viewlod::ViewState& view, const std::filesystem::path& file) = 0;
};

/// Returns a painter. Errors: there is no graphics context, or the program has none.
foundation::Result<std::unique_ptr<MeshPainter>> makePainter();

} // namespace terraintool
