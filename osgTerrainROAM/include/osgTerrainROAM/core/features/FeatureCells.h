// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <foundation/ContentMark.h>
#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// Vector features in square cells, for a fragment shader. Each cell lists the features that lie in it or
/// within kReachM of it: a fragment whose filter is no wider than 2·kReachM reads its own cell alone.
/// Positions in a record are relative to the middle of its cell: single precision resolves 8 µm there,
/// however large the tile is.
///
/// Records are texels of four floats. A cell's list holds, in this order:
/// - areas, in the order of painting; each is [edges, kind, crop, seed] [row direction east, north, its
///   middle's place across and along the rows modulo kWayPeriodM] and `edges` × [east, north, east, north]: a
///   clipped polygon's edges, less those that no ray to the east can meet;
/// - lines, rivers before roads; each is [east, north, east, north] [half width, way to its first end modulo
///   kWayPeriodM, code, road's number], with code = kind + 4·pavement + 16·lanes + 256·marked;
/// - strokes; each is [east, north, east, north] [half width, paint, 0, 0]: a rectangle with a middle line.
///
/// Frame: the tile's local east and north. Units: metres. Cells are counted from the frame's origin, so that
/// 4096 m are a whole number of them. Memory: 16 B a cell of the bounding rectangle and 16 B a texel.
/// Invariant: every list lies within the records (isConsistent()). Threads: immutable after build().
/// Source: the lists are those of Nehab and Hoppe, Random-access rendering of general vector graphics (2008),
/// section 3; here the polygons keep even-odd parity by clipping, and lines are strokes of constant width
/// evaluated by distance.
struct FeatureCells
{
    static constexpr double kReachM = 16.0;
    static constexpr double kLampReachM = 64.0; ///< of lamps: a light one pixel wide is long on the ground
    static constexpr double kWayPeriodM = 24.0; ///< a multiple of all dashes' periods

    /// A cell: the first record of its list, and the numbers of its areas, lines and strokes.
    struct Cell
    {
        std::uint32_t first = 0, areas = 0, lines = 0, strokes = 0;
    };

    /// What a stroke paints, in the order of painting: a runway covers what leads to it.
    enum Paint
    {
        yellow, ///< lines of taxiways
        asphalt,
        white,
        rubber,    ///< of tyres, where aircraft touch down
        edgeLight, ///< of a runway, at night
    };

    /// A straight runway: far maps are too coarse for what a pilot looks for.
    struct Runway
    {
        glm::dvec2 from{0.0}, to{0.0};
        double widthM = 0.0;
    };

    double cellM = 64.0; ///< a power of two, 16 … 256
    glm::ivec2 firstCell{0};
    int columns = 0, rows = 0;
    std::vector<Cell> cells; ///< row-major, southernmost first
    std::vector<std::array<float, 4>> records;
    std::vector<Runway> runways;

    /// The cell that holds a position; null beyond all features.
    const Cell* cellAt(const glm::dvec2& place) const;
    /// A position relative to the middle of its cell.
    glm::dvec2 inCell(const glm::dvec2& place) const;
    bool isConsistent() const;

    /// Errors: more records than single precision can number (16 million), more than 4 million cells of 256
    /// m.
    static foundation::Result<FeatureCells> build(const std::vector<GroundFeature>& features);
};

/// The mark of all values of cells.
foundation::ContentMark markOfCells(const FeatureCells& cells);

} // namespace osgTerrainROAM::core
