// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// What a vector feature is painted as. In the order of painting: the later lies on top.
enum class FeatureKind
{
    field,
    river,
    road,
    runway,
};

/// What a road's or runway's bed is of.
enum class Pavement
{
    asphalt,
    gravel,
    earth,
};

/// What grows on a field.
enum class Crop
{
    cereal,
    rowCrop, ///< maize, beets, rape
    grassland,
    orchard,
};

/// How one feature looks. Units: metres.
struct FeatureStyle
{
    FeatureKind kind = FeatureKind::road;
    double widthM = 7.0; ///< of a line, edge to edge
    int lanes = 2;       ///< of a road, both directions together
    bool marked = true;  ///< has lines painted on it
    Pavement pavement = Pavement::asphalt;
    Crop crop = Crop::cereal;
    bool isCropKnown = false; ///< else a third of the cereal fields are given row crops, for variety
    std::string designator;   ///< of a runway, "09/27"; empty: not known

    bool operator==(const FeatureStyle&) const = default;
};

/// A line (one path or several) or an area (rings, even-odd: what an odd number of them holds is inside).
/// Frame: the tile's local east and north, metres. Rings are not closed: the last point is not the first again.
struct GroundFeature
{
    FeatureStyle style;
    bool isArea = false;
    std::vector<std::vector<glm::dvec2>> paths;
};

/// What became of the features of a source. Nothing is lost without being counted here.
struct FeatureReport
{
    std::size_t read = 0;
    std::size_t taken = 0;
    std::size_t outside = 0;                    ///< wholly beyond the tile's data
    std::size_t invalid = 0;                    ///< no geometry, too few points, or no place on the tile
    std::map<std::string, std::size_t> unknown; ///< of no known kind, by what they call themselves

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
