// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/Geodetic.h>
#include <osgTerrainROAM/core/heightfield/GeodeticLattice.h>
#include <osgTerrainROAM/core/heightfield/PlanExpansion.h>
#include <osgTerrainROAM/core/heightfield/TileGrid.h>

namespace osgTerrainROAM::core
{

/// How samples become 3D positions.
enum class Placement
{
    curved, ///< on the WGS84 ellipsoid, east-north-up about an origin; needs a georeference
    planar, ///< x = column·spacing, y = row·spacing, z = height
};

/// The frame of a tile maps grid coordinates and heights to positions, and back.
/// Frame: curved: local east-north-up metres about origin(); planar: metres about the south-western sample.
/// Heights are metres as the samples count them. Threads: immutable.
class TileFrame
{
public:
    /// A planar frame. `spacing…M`: from one sample of the raster to the next.
    TileFrame(const TileGrid& grid, double spacingEastM, double spacingNorthM);

    /// A curved frame. `origin` absent: the centre of the data at ellipsoidal height 0. `middleHeightM`: of
    /// the ground at the tile's middle, about which gridNear() is exact.
    TileFrame(const TileGrid& grid, GeodeticLattice lattice, double middleHeightM);

    Placement placement() const { return _lattice ? Placement::curved : Placement::planar; }

    /// Geodetic position of the frame's origin. Planar: zeros.
    Geodetic origin() const { return _lattice ? _lattice->origin() : Geodetic{}; }

    /// Position of a grid point, 0 ≤ column, row < side. Cost: about 60 flops (curved), 2 (planar).
    glm::dvec3 positionOf(int column, int row, double heightM) const
    {
        if (_lattice) return _lattice->position(column, row, heightM);
        return {column * _pointEastM, row * _pointNorthM, heightM};
    }

    /// The same between grid points.
    glm::dvec3 positionAt(double column, double row, double heightM) const
    {
        if (_lattice) return _lattice->positionAt(column, row, heightM);
        return {column * _pointEastM, row * _pointNorthM, heightM};
    }

    /// Grid coordinates (column, row) under or above `local`, along the ellipsoid's normal there (planar:
    /// along z): positionAt(gridAt(p), h) = p for the height h of p. Points beyond the tile are extrapolated.
    glm::dvec2 gridAt(const glm::dvec3& local) const;

    /// Height of a local position: positionAt(gridAt(p), heightOf(p)) = p.
    double heightOf(const glm::dvec3& local) const;

    /// Approximate grid coordinates at which a vertical line meets the ground: the start of a search. Curved:
    /// off by the effects of height and of the third order of the Earth's curvature, less than a sample in
    /// tiles of up to 100 km; planar: exact.
    /// Cost: about 30 flops.
    glm::dvec2 gridNear(const glm::dvec2& local) const
    {
        return _lattice ? _plan.gridNear(local) : glm::dvec2(local.x / _pointEastM, local.y / _pointNorthM);
    }

    /// Grid coordinates to first order about the tile's middle: linear · local + offset. Off by far less than
    /// 2^15 points in tiles of up to 200 km: enough to tell a vertex's grid point from its lower 16 bits
    /// (MeshVertex).
    struct GridMap
    {
        glm::dmat2 linear;
        glm::dvec2 offset;
    };
    GridMap gridMap() const;

    /// Step in which the positions of drawn vertices are counted (MeshVertex): a power of two such that 31
    /// bits reach 20 km beyond every sample; 0.06 mm on a tile of 60 km.
    double vertexStepM() const { return _vertexStepM; }

    /// Conversions between the local frame and WGS84. Curved frames alone (asserted).
    glm::dvec3 localFromGeodetic(const Geodetic& geodetic) const;
    Geodetic geodeticFromLocal(const glm::dvec3& local) const;

private:
    double fittingStepM() const;

    int _side;
    double _pointEastM = 1.0, _pointNorthM = 1.0; ///< from one grid point to the next, planar
    std::optional<GeodeticLattice> _lattice;      ///< curved
    PlanExpansion _plan;
    double _vertexStepM;
};

} // namespace osgTerrainROAM::core
