// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// The kind of a vector feature, in the order of painting: a later kind lies on top.
enum class FeatureKind
{
    field,
    river,
    road,
    runway,
};

/// The material of a road's or runway's surface.
enum class Pavement
{
    asphalt,
    gravel,
    earth,
};

/// The crop of a field.
enum class Crop
{
    cereal,
    rowCrop, ///< maize, beets, rape
    grassland,
    orchard,
};

/// Whether aircraft taxi along a way; if so, it has a yellow line where it is paved.
enum class Taxiing
{
    none,
    taxiway,  ///< has lamps along its edges, too
    taxilane, ///< on an apron, or leads to one stand
};

/// The appearance of one feature. Units: metres.
struct FeatureStyle
{
    FeatureKind kind = FeatureKind::road;
    double widthM = 7.0; ///< of a line, from edge to edge
    int lanes = 2;       ///< of a road, in both directions together
    bool marked = true;  ///< has painted lines
    Taxiing taxiing = Taxiing::none;
    Pavement pavement = Pavement::asphalt;
    Crop crop = Crop::cereal;
    bool isCropKnown = false; ///< if not, a third of the cereal fields get row crops, for variety
    std::string designator;   ///< of a runway, "09/27"; empty: unknown

    bool operator==(const FeatureStyle&) const = default;
};

/// Whether a line is a taxiway or taxilane with yellow lines.
inline bool isPavedTaxiway(const FeatureStyle& style)
{
    return style.taxiing != Taxiing::none && style.pavement == Pavement::asphalt;
}

/// A line (of one or more paths) or an area (of rings, by the even-odd rule).
/// Frame: the tile's local east and north, metres. Rings do not repeat their first point at the end.
struct GroundFeature
{
    FeatureStyle style;
    bool isArea = false;
    std::vector<std::vector<glm::dvec2>> paths;
};

/// The report of an import. It counts every feature of the source.
struct FeatureReport
{
    std::size_t read = 0;
    std::size_t taken = 0;
    std::size_t outside = 0;                    ///< wholly beyond the tile's data
    std::size_t invalid = 0;                    ///< no geometry, too few points, or no position on the tile
    std::map<std::string, std::size_t> unknown; ///< of no known kind, by the tag that names their kind
    std::vector<std::string> notes{};           ///< what GDAL warned of, one line each

    /// One line: "12 of 20 features painted; 3 outside; 1 invalid; 4 unknown: highway=steps 3, (no tags) 1".
    std::string message() const;
};

/// The features of one or more sources.
struct FeatureSet
{
    std::vector<GroundFeature> features;
    FeatureReport report;

    void append(FeatureSet other);
};

} // namespace osgTerrainROAM::core
