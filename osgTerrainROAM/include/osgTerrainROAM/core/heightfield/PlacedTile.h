// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/FineSamples.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/SampleSheet.h>
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

/// What a tile is made with besides its heights.
struct PlacedTileOptions
{
    Placement placement = Placement::curved; ///< a field without georeference is always planar
    Storage storage = Storage::compact;
    std::optional<Geodetic> origin =
        std::nullopt;     ///< of the frame; absent: the data's centre at ellipsoidal height 0
    int gridExponent = 0; ///< the grid has 2^gridExponent places from one sample to the next
};

/// A height field as a square tile of 2^N+1 grid places a side, each of which has a position in the local frame.
/// The grid is the samples' own, or finer by a power of two (gridExponent), so that edits can put samples between them;
/// places without a sample lie on the surface of the samples around them and count in no error. Parts of the field that
/// are denser lie over it as sheets, on the same grid. Columns and rows are
/// those of the grid everywhere but where samples are mentioned.
/// Places beyond the data repeat the edge's height; they exist only so that the bintree is complete, count
/// in no error and are clipped when drawn (dataColumns, dataRows). Curved: a lattice of exact positions and
/// ellipsoid normals at the nodes of the field's GeodeticNet is interpolated biquadratically, so a position
/// is a pure function of its place and height, the same bits on every call.
/// Frame: local east-north-up metres about `origin()`; planar: about the south-west sample.
/// Threads: const from any, while nobody sets a height. Memory: the samples (SampleTable, FineSamples), plus 48 B per
/// lattice node.
/// Source: spec 1, "The wheel in formulas": X(s), the placed 3D position of a sample.
class PlacedTile
{
public:
    explicit PlacedTile(HeightField field, const PlacedTileOptions& options);
    explicit PlacedTile(HeightField field, Placement placement = Placement::curved,
                        Storage storage = Storage::compact)
        : PlacedTile(std::move(field), PlacedTileOptions{placement, storage, std::nullopt, 0})
    {
    }
    PlacedTile(HeightField field, const Geodetic& origin)
        : PlacedTile(std::move(field), PlacedTileOptions{.origin = origin})
    {
    }

    static constexpr int kMostSide = (1 << 20) + 1; ///< grid places
    static constexpr int kMostLevels = 2 * 20;      ///< of its bintree

    int side() const { return _side; }     ///< grid places along the tile, 2^N+1
    int levels() const { return _levels; } ///< 2N: bintree levels below the two roots that can split
    int dataColumns() const { return _dataColumns; }
    int dataRows() const { return _dataRows; }
    int gridExponent() const { return _gridExponent; }

    /// What the field says of itself; its heights are in samples().
    const HeightField& field() const { return _field; }
    const SampleTable& samples() const { return _samples; }
    SampleTable& samples() { return _samples; }
    const Geodetic& origin() const { return _origin; }
    Placement placement() const { return _placement; }

    bool isInData(int column, int row) const { return column < _dataColumns && row < _dataRows; }

    /// Whether the data have holes, or an outline that is not a rectangle.
    bool hasHoles() const { return !_field.mask.hasAll(); }

    /// Whether the ground reaches a place of the data: a sample that is there, or a place on one of the raster's finest triangles
    /// whose three corners are.
    bool isGround(int column, int row) const
    {
        if (!hasHoles()) [[likely]]
            return true;
        return isOfRaster(column, row) ? hasSampleOfRaster(column, row) : isGroundBetween(column, row);
    }

    /// How many samples of the raster, from `west` to `east` along a row of it, are there. Places of the grid, all of the raster.
    int samplesIn(int row, int west, int east) const
    {
        return _field.mask.countIn(row >> _gridExponent, west >> _gridExponent, east >> _gridExponent);
    }

    /// Height, error and radius of a place of the data. Where no sample is, the height is that of the surface, and the
    /// rest is 0.
    SampleTable::Sample sample(int column, int row) const
    {
        SampleTable::Sample sample;
        if (isOfRaster(column, row) && _samples.read(rasterIndex(column, row), sample)) [[likely]]
            return sample;
        return sampleBetween(column, row);
    }

    /// Of a place, or of the nearest one at the edge of the data.
    float heightM(int column, int row) const
    {
        const int c = std::clamp(column, 0, _dataColumns - 1), r = std::clamp(row, 0, _dataRows - 1);
        if (isOfRaster(c, r)) [[likely]]
        {
            const std::size_t index = rasterIndex(c, r);
            if (!_samples.isElsewhere(index)) [[likely]]
                return _samples.heightM(index);
        }
        return sampleBetween(c, r).heightM;
    }

    /// Tells the processor that a place of the data will be asked for.
    void prefetch(int column, int row) const { _samples.prefetch(rasterIndex(column, row)); }

    /// Calls visit(column, row) for every place of a rectangle within the data that has a sample, or counts among them: the
    /// raster's and those between. Some may be given twice.
    template<class Visit>
    void forEachSample(const GridRect& rect, const Visit& visit) const
    {
        const GridRect cut = rect.cutTo({0, 0, _dataColumns - 1, _dataRows - 1});
        const auto visitGround = [&](int column, int row)
        {
            if (isGround(column, row)) visit(column, row);
        };
        cut.forEachMultipleOf(1 << _gridExponent, visitGround);
        for (const SampleSheet& sheet : _sheets)
            cut.cutTo(sheet.inside()).forEachMultipleOf(sheet.step(), visitGround);
        if (!_fine.isEmpty()) _fine.forEachIn(cut, visit);
    }
    const FineSamples& fineSamples() const { return _fine; }
    const std::vector<SampleSheet>& sheets() const { return _sheets; }

    /// Places from a sample at this one to the next: of the raster, or of a sheet; 1 for one that an edit has put there.
    int sampleStep(int column, int row) const
    {
        if (const SampleSheet* sheet = sheetAt(column, row)) return sheet->step();
        return isOfRaster(column, row) ? 1 << _gridExponent : 1;
    }

    /// Whether a sample of the raster belongs there.
    bool isOfRaster(int column, int row) const { return ((column | row) & _betweenSamples) == 0; }

    /// Whether a sample of the raster or of a sheet belongs there.
    bool isMeasured(int column, int row) const { return isOfRaster(column, row) || sheetAt(column, row); }

    /// Gives a sample of the raster, or of a sheet, another height: the surface between the samples follows. Kept exactly; where
    /// the table cannot, places between follow to its nearest step.
    void setSampleHeight(int column, int row, float heightM);

    /// Puts a sample at a place of the data, or another in its place; the surface of the raster around it stays as it is.
    void setFineHeight(int column, int row, float heightM);
    /// Counts a place among the samples that keeps following the surface between them. Nothing where a sample is.
    void count(int column, int row);

    /// Whether a sample is kept there that is not the raster's.
    bool hasFineSample(int column, int row) const
    {
        const SampleTable::Sample* kept = _fine.find(column, row);
        return kept && FineSamples::hasHeight(*kept);
    }

    bool hasSample(int column, int row) const
    {
        return isMeasured(column, row) || hasFineSample(column, row);
    }

    /// All that is kept of a place of the data; to put it back.
    struct Kept
    {
        SampleTable::Sample inTable{}, inSheet{}, inFine{};
        bool isInTable = false, isInSheet = false, isInFine = false, isElsewhere = false;
    };
    Kept kept(int column, int row) const;
    void restore(int column, int row, const Kept& kept);

    /// What a place keeps of an error or a radius: the least value that is not less.
    float roundedUpError(int column, int row, double errorM) const;
    float roundedUpRadius(int column, int row, double radiusM) const;

    /// Keeps what roundedUp…() gave.
    void setBound(int column, int row, float errorM, float radiusM);

    /// Position of a place of the grid, 0 ≤ column, row < side. Cost: about 60 flops (curved), 2 (planar).
    glm::dvec3 position(int column, int row) const { return positionOf(column, row, heightM(column, row)); }

    /// The same for who has looked the height up already.
    glm::dvec3 positionOf(int column, int row, double heightM) const
    {
        if (_placement == Placement::curved) return curvedPosition(column, row, heightM);
        return {column * _placeEastM, row * _placeNorthM, heightM};
    }

    /// Steps that the positions of drawn vertices are counted in (MeshVertex): a power of two, 0.06 mm on a tile of 60 km,
    /// such that 31 bits reach 20 km beyond every sample.
    double vertexStepM() const { return _vertexStepM; }

    /// Position of a fractional grid place at a given height (metres, as the samples are counted).
    glm::dvec3 positionAt(double column, double row, double heightM) const;

    /// Grid place (column, row) under or above `local`, along the ellipsoid's normal there (planar: along z):
    /// positionAt(gridAt(p), h) = p for the height h of p. Places beyond the tile are extrapolated.
    glm::dvec2 gridAt(const glm::dvec3& local) const;

    /// Position of a sample of the raster without what fine edits have put in its place: of the surface around it.
    glm::dvec3 rasterPosition(int column, int row) const
    {
        return positionOf(column, row, _samples.heightM(rasterIndex(column, row)));
    }

    /// Height of a local position, as the samples are counted: positionAt(gridAt(p), heightOf(p)) = p.
    double heightOf(const glm::dvec3& local) const;

    /// About where the vertical line through a place meets the ground: where a search for it begins. Curved: off by what
    /// height and the third order of the Earth's curvature shift, less than a sample in tiles of up to 100 km; planar: exact.
    /// Cost: about 30 flops.
    glm::dvec2 gridNear(const glm::dvec2& place) const;

    /// The grid place of a local one to first order about the tile's middle: linear · place + offset. Off by far less than
    /// 2^15 places in tiles of up to 200 km: enough to tell a vertex's place from its lower 16 bits (MeshVertex).
    struct GridMap
    {
        glm::dmat2 linear;
        glm::dvec2 offset;
    };
    GridMap gridMap() const;

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

    std::size_t rasterIndex(int column, int row) const
    {
        return static_cast<std::size_t>(row >> _gridExponent) * static_cast<std::size_t>(_field.columns) +
               static_cast<std::size_t>(column >> _gridExponent);
    }
    bool hasSampleOfRaster(int column, int row) const
    {
        return _field.mask.holds(column >> _gridExponent, row >> _gridExponent);
    }
    bool isGroundBetween(int column, int row) const;
    SampleTable::Sample sampleBetween(int column, int row) const;
    /// Of the raster with the first `sheets` of its sheets over it, without what edits have put between.
    float surfaceM(int column, int row, std::size_t sheets) const;
    const SampleSheet* sheetAt(int column,
                               int row) const; ///< the finest that holds a sample there; null: none
    SampleSheet* sheetAt(int column, int row)
    {
        return const_cast<SampleSheet*>(std::as_const(*this).sheetAt(column, row));
    }
    const SampleTable* tableOf(int column, int row) const;
    void laySheets(std::vector<DensePart> parts, Storage storage);
    void fade(DensePart& part) const;
    bool isInTable(int column, int row) const
    {
        return isOfRaster(column, row) && !_samples.isElsewhere(rasterIndex(column, row));
    }
    glm::dvec3 curvedPosition(int column, int row, double heightM) const;
    static Weights weightsAt(double nodesFromFirst);
    static Weights slopesAt(double nodesFromFirst);
    void initSide();
    void initLatticePlaces();
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
    std::vector<SampleSheet> _sheets; ///< coarse before fine
    FineSamples _fine;
    Placement _placement;
    Geodetic _origin;
    int _gridExponent = 0;
    int _betweenSamples = 0; ///< bits of a coordinate that a sample of the raster has not
    int _side = 0;
    int _levels = 0;
    int _dataColumns = 0, _dataRows = 0;
    double _placeEastM = 1.0, _placeNorthM = 1.0; ///< from one grid place to the next
    double _vertexStepM = 1.0;
    int _latticeStep = 0;          ///< grid places between nodes
    int _latticeSide = 0;          ///< nodes along the tile, odd: whole macro cells of 2×2 steps
    int _macroShift = 0;           ///< log2(2·step): a place's macro cell is index >> shift
    std::vector<Weights> _weights; ///< per sample offset within a macro cell
    std::vector<LatticeNode> _lattice;
    Sketch _sketch;
};

} // namespace osgTerrainROAM::core
