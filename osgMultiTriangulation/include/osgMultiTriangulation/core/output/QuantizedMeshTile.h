// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/surface/PlanFrame.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A tile of the Earth: at level 0 there are two, side by side; each has four at the next level. Columns
/// count to the east from 180° W, rows to the north from the south pole. Units: degrees.
struct EarthTile
{
    static constexpr std::uint32_t kLeastLevel = 3, kMostLevel = 22;

    std::uint32_t level = kLeastLevel, column = 0, row = 0;

    double side() const;
    double west() const { return westOf(column); }
    double south() const { return southOf(row); }
    double east() const { return westOf(column + 1.0); }
    double north() const { return southOf(row + 1.0); }

private:
    double westOf(double at) const { return -180.0 + at * side(); }
    double southOf(double at) const { return -90.0 + at * side(); }
};

/// Returns the tile whose name is LEVEL/COLUMN/ROW. Errors: another form; a level, column or row that is not
/// there.
foundation::Result<EarthTile> earthTileOf(const std::string& name);

/// Returns a tile of quantized-mesh 1.0 of a surface: its triangles within the tile, cut at the sides. Places
/// are rounded to 1/32767 of a side, heights to as much of what they span. What has been taken from one
/// surface fits from tile to tile, to the rounding of heights.
/// `frame`: its reference system is in degrees (a well-known text that begins with GEOG); the datum is taken
/// for WGS 84. `file`: for messages.
/// Source: *quantized-mesh-1.0 terrain format* (Cesium); the point that tells whether the tile is below the
/// horizon: Ring, *Computing the horizon occlusion point* (2013); cutting: Sutherland & Hodgman, *Reentrant
/// polygon clipping* (1974).
/// Errors: no reference system in degrees; no triangle within the tile; points nearer to each other than the
/// rounding, so that a triangle turns over.
foundation::Result<std::string> quantizedMeshOf(const SurfaceMesh& mesh, const PlanFrame& frame,
                                                const EarthTile& tile, const std::string& file);

} // namespace osgMultiTriangulation::core
