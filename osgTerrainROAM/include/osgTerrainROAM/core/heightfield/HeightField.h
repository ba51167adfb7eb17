// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <osgTerrainROAM/core/heightfield/SampleMask.h>

namespace osgTerrainROAM::core
{

/// Geodetic positions at a coarse, regular subset of a height field's samples; interpolation between them
/// gives the position of every sample. So geographic and projected rasters are alike after the import, and
/// only the import uses map projections (PROJ). Node (a, b) is sample (column, row) = (a·step, b·step); nodes
/// cover the padded 2^n+1 tile.
/// Units: degrees; metres for the geoid's height above the ellipsoid.
struct GeodeticNet
{
    struct Node
    {
        double latitudeDeg;
        double longitudeDeg;
        double geoidM; ///< added to samples to give ellipsoidal heights; 0 when they are ellipsoidal already
    };

    int step = 0; ///< samples between nodes, a power of two
    int nodesPerSide = 0;
    std::vector<Node> nodes; ///< row-major, southernmost row first

    const Node& node(int a, int b) const { return nodes[static_cast<std::size_t>(b) * nodesPerSide + a]; }
};

/// The report on missing samples and on how they were filled.
struct VoidReport
{
    std::size_t count = 0;
    double share = 0.0; ///< of all samples, 0…1
    std::string method; ///< of filling; empty when there was nothing to fill
};

/// The report on joining several rasters.
struct MosaicReport
{
    int rasters = 1;
    std::size_t bentSamples = 0; ///< interpolated or coarser samples that were moved to meet finer data
    double largestStepM = 0.0;   ///< largest disagreement of rasters along the seams
};

/// A rectangle of a height field whose samples are denser than the field's by a power of two.
struct DensePart
{
    int west = 0, south = 0;   ///< the field's sample at its south-western corner
    int columns = 0, rows = 0; ///< size in cells of the field
    int exponent = 1;          ///< 2^exponent of its samples lie along a cell of the field
    std::vector<float>
        heightsM; ///< (columns·2^exponent + 1) × (rows·2^exponent + 1), row-major, southernmost first
};

/// A regular grid of height samples, complete: voids are filled already.
/// Sample (column, row): column 0 is the westernmost, row 0 the *southernmost*; storage is row-major.
/// Units: metres above the file's vertical datum; GeodeticNet::Node::geoidM leads to ellipsoidal heights.
/// Invariant: heights.size() == columns·rows, both ≥ 2, all finite; isComplete() checks.
struct HeightField
{
    std::string name; ///< of the source, for messages
    int columns = 0;
    int rows = 0;
    std::vector<float> heightsM;
    double spacingEastM = 0.0; ///< mean sample distance on the ground
    double spacingNorthM = 0.0;
    std::optional<GeodeticNet> net; ///< absent: no georeference; then a plane with the spacings above
    VoidReport voids;
    MosaicReport mosaic;
    std::vector<std::string> notes; ///< what GDAL warned of, and what else is unusual; one line each
    std::vector<DensePart> parts;   ///< coarse before fine; where they overlap the later one counts
    SampleMask measured; ///< tells which samples come from the data; the others were voids and are filled
    SampleMask
        mask; ///< tells which samples exist; the others have a height only so that the grid is complete

    /// Height of a sample; beyond the data, that of the nearest edge sample.
    float heightM(int column, int row) const
    {
        const int c = std::clamp(column, 0, columns - 1);
        const int r = std::clamp(row, 0, rows - 1);
        return heightsM[static_cast<std::size_t>(r) * columns + c];
    }

    /// Side, in samples, of the smallest 2^n+1 square that contains the grid.
    int tileSide() const
    {
        int cells = 2;
        while (cells < std::max(columns, rows) - 1)
            cells *= 2;
        return cells + 1;
    }

    bool isComplete() const;
};

} // namespace osgTerrainROAM::core
