// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/SampleTable.h>

namespace osgTerrainROAM::core
{

/// WGS84 position. Units: degrees, metres above the ellipsoid.
struct Geodetic
{
    double latitudeDeg = 0.0;
    double longitudeDeg = 0.0;
    double heightM = 0.0;
};

/// How samples become 3D positions.
enum class Placement
{
    curved, ///< on the WGS84 ellipsoid, east-north-up about an origin; needs a georeference
    planar, ///< x = column·spacing, y = row·spacing, z = height: the anchors' convention
};

/// A height field as a square tile of 2^n+1 samples whose every sample has a position in the local frame.
/// Samples beyond the data repeat the edge's height; they exist only so that the bintree is complete, count
/// in no error and are clipped when drawn (dataColumns, dataRows). Curved: a lattice of exact positions and
/// ellipsoid normals at the nodes of the field's GeodeticNet is interpolated biquadratically, so a position
/// is a pure function of its sample, the same bits on every call.
/// Frame: local east-north-up metres about `origin()`; planar: about the south-west sample.
/// Threads: immutable after construction. Memory: the samples (SampleTable), plus 48 B per lattice node.
/// Source: spec 1, "The wheel in formulas": X(s), the placed 3D position of a sample.
class PlacedTile
{
public:
    /// `origin` of the frame; absent: the data's centre at ellipsoidal height 0. A field without
    /// georeference is always planar.
    explicit PlacedTile(HeightField field, Placement placement = Placement::curved,
                        Storage storage = Storage::compact);
    PlacedTile(HeightField field, const Geodetic& origin);

    int side() const { return _side; }     ///< samples along the tile, 2^n+1
    int levels() const { return _levels; } ///< 2n: bintree levels below the two roots that can split
    int dataColumns() const { return _field.columns; }
    int dataRows() const { return _field.rows; }

    /// What the field says of itself; its heights are in samples().
    const HeightField& field() const { return _field; }
    const SampleTable& samples() const { return _samples; }
    SampleTable& samples() { return _samples; }
    const Geodetic& origin() const { return _origin; }
    Placement placement() const { return _placement; }

    float heightM(int column, int row) const { return _samples.heightM(sampleIndex(column, row)); }

    bool isInData(int column, int row) const { return column < _field.columns && row < _field.rows; }

    /// Of a sample, or of the nearest one at the edge of the data.
    std::size_t sampleIndex(int column, int row) const
    {
        const int c = std::clamp(column, 0, _field.columns - 1), r = std::clamp(row, 0, _field.rows - 1);
        return static_cast<std::size_t>(r) * static_cast<std::size_t>(_field.columns) +
               static_cast<std::size_t>(c);
    }

    /// Position of a sample of the tile, 0 ≤ column, row < side. Cost: about 60 flops (curved), 2 (planar).
    glm::dvec3 position(int column, int row) const { return positionOf(column, row, heightM(column, row)); }

    /// The same for who has looked the sample's height up already.
    glm::dvec3 positionOf(int column, int row, double heightM) const
    {
        if (_placement == Placement::curved) return curvedPosition(column, row, heightM);
        return {column * _field.spacingEastM, row * _field.spacingNorthM, heightM};
    }

    /// Steps that the positions of drawn vertices are counted in (MeshVertex): a power of two, 0.06 mm on a tile of 60 km,
    /// such that 31 bits reach 20 km beyond every sample.
    double vertexStepM() const { return _vertexStepM; }

    /// Position of a fractional grid place at a given height (metres, as the samples are counted).
    glm::dvec3 positionAt(double column, double row, double heightM) const;

    /// Grid place (column, row) under or above `local`, along the ellipsoid's normal there (planar: along z):
    /// positionAt(gridAt(p), h) = p for the height h of p. Places beyond the tile are extrapolated.
    glm::dvec2 gridAt(const glm::dvec3& local) const;

    /// About where the vertical line through a place meets the ground: where a search for it begins. Curved: off by what
    /// height and the third order of the Earth's curvature shift, less than a sample in tiles of up to 100 km; planar: exact.
    /// Cost: about 30 flops.
    glm::dvec2 gridNear(const glm::dvec2& place) const;

    /// Conversions of the frame (identity-like about the origin for planar tiles: unavailable, asserted).
    glm::dvec3 localFromGeodetic(const Geodetic& geodetic) const;
    Geodetic geodeticFromLocal(const glm::dvec3& local) const;

private:
    /// Local position at sample height 0, and the ellipsoid's normal in the local frame: side by side, so that they are
    /// interpolated two numbers at a time.
    struct LatticeNode
    {
        std::array<double, 6> values{};
        LatticeNode() = default;
        LatticeNode(const glm::dvec3& base, const glm::dvec3& up)
            : values{base.x, base.y, base.z, up.x, up.y, up.z}
        {
        }
        glm::dvec3 base() const { return {values[0], values[1], values[2]}; }
        glm::dvec3 up() const { return {values[3], values[4], values[5]}; }
    };

    /// Quadratic Lagrange weights of three nodes in a row, or their derivatives.
    struct Weights
    {
        double w[3];
    };

    /// Where a grid place falls: its macro cell (3×3 nodes) and how many nodes into it.
    struct LatticePlace
    {
        int macroColumn, macroRow;
        double east, north; ///< 0…2
    };

    /// The horizontal place to second order about the middle of the tile: local + J·d + d.x²·xx + d.x·d.y·xy + d.y²·yy.
    struct Sketch
    {
        glm::dvec2 grid{0.0}, local{0.0};
        glm::dmat2 inverse{1.0}; ///< of J
        glm::dvec2 xx{0.0}, xy{0.0}, yy{0.0};
    };

    glm::dvec3 curvedPosition(int column, int row, double heightM) const;
    static Weights weightsAt(double nodesFromFirst);
    static Weights slopesAt(double nodesFromFirst);
    void initSide();
    void initRadiusRange();
    void initVertexStep();
    void buildLattice();
    void drawSketch();
    Geodetic dataCentre() const;
    LatticePlace latticePlace(double column, double row) const;
    LatticeNode blend(int macroColumn, int macroRow, const Weights& wx, const Weights& wy) const;
    glm::dvec2 newtonStep(const glm::dvec2& grid, const glm::dvec3& local) const;

    HeightField _field;
    SampleTable _samples;
    Placement _placement;
    Geodetic _origin;
    int _side = 0;
    int _levels = 0;
    double _vertexStepM = 1.0;
    int _latticeStep = 0;          ///< samples between nodes
    int _latticeSide = 0;          ///< nodes along the tile, odd: whole macro cells of 2×2 steps
    int _macroShift = 0;           ///< log2(2·step): a sample's macro cell is index >> shift
    std::vector<Weights> _weights; ///< per sample offset 0…2·step within a macro cell
    std::vector<LatticeNode> _lattice;
    Sketch _sketch;
};

} // namespace osgTerrainROAM::core
