// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/method/Method.h>

namespace osgTerrainROAM::core
{

/// What the heights themselves say of water, besides what features and land cover call so.
enum class WaterRule
{
    level, ///< level ground is a lake, flat ground at or below the sea is sea
    sea,   ///< the sea alone
    none   ///< all ground is land
};

/// Parameters of the land's appearance. Absent values follow from latitude and longitude
/// (osgTerrainROAM::Climate).
/// Units: metres in the samples' datum, shares 0…1.
struct LandParameters
{
    std::optional<double> aridity; ///< 0 wet and green … 1 desert
    std::optional<double> treeLineM;
    std::optional<double> snowLineM;
    std::optional<double> seaLevelM;
    WaterRule water = WaterRule::level;
};

/// Where the (0, 0) of a road network lies that has no georeference of its own. Units: degrees.
struct RoadsOrigin
{
    double latitudeDeg = 0.0, longitudeDeg = 0.0;
    double headingDeg = 0.0; ///< of the network's y axis, clockwise from north
};

/// The content of a `.roam` file, which describes a terrain. Text, one `key = value` a line, `#` starts a
/// comment.
///   dem = FILE                        an elevation raster; the only required key. Several are joined
///                                     (importDems)
///   voids = fill | keep | show        missing samples: filled smoothly, or holes in the ground, or filled
///                                     and coloured
///   imagery = FILE                    any raster GDAL opens, draped over the terrain; up to four, the finest
///                                     wins
///   features = FILE                   roads, rivers, fields, runways of any source that OGR opens; may be
///                                     repeated
///   buildings = FILE                  footprints of buildings, of any source that OGR opens; may be repeated
///   objects = FILE                    points where generated models stand; may be repeated
///   structures = FILE                 lines and points of walls, fences, power lines, railways, turbines;
///                                     may be repeated
///   earthworks = FILE                 areas and lines with heights that the ground is cut and filled to; may
///                                     be repeated
///   land_cover = FILE                 a raster of classes
///   land_cover_classes = worldcover | corine | FILE    what its classes mean (CoverTable.h)
///   season = MONTH | 0…1              january … december, or a share of the year; absent: early summer
///   roads = FILE.xodr                 a road network that the ground is cut to
///   edits = FILE                      heights that edits have left (EditFile.h), in place of cutting the
///                                     ground to the roads
///   roads_origin = LAT LON [HEADING]  of the network's (0, 0), degrees; heading of its y axis, clockwise
///                                     from north
///   roads_heights = file | ground     the network's own heights, or added to those of the smoothed ground
///   origin = LAT LON [HEIGHT]         of the local frame, degrees and metres
///   placement = curved | planar
///   spacing = METRES                  of a raster without georeference
///   finest_spacing = METRES           of samples that edits may add; absent: edits change the raster's
///                                     samples only
///   vertical_datum = automatic | egm96 | ellipsoid
///   method = NAME                     of level of detail (Method.h)
///   error_tolerance = PIXELS          max_triangles = COUNT
///   view_margin = DEGREES             refines only what is seen and so much beside it; absent: all around
///   aridity = 0…1    tree_line = METRES    snow_line = METRES    sea_level = METRES
///   water = level | none              level ground and ground below the sea is water, or all ground is land
///   sun = AZIMUTH ELEVATION           degrees, below the horizon at night        visibility = METRES
///   moonlight = 0…1                   1: a full moon, high up
///   clouds = OKTAS KIND BASE TOP [; …] layers of clouds, metres above the ground at the origin; or none
///   ground = PART [; …]               what lies on it: dry, moist, wet, puddles, water MM, ice, snow CM,
///                                       cleared
///   surroundings = made | none        beyond the data: made-up ground to the horizon, or nothing
/// Relative paths are relative to the file's folder; names that begin with /vsi are GDAL's and stay as they
/// are. Errors, with place "file:line": unknown or repeated key, missing dem, bad number.
struct RoamFile
{
    std::vector<std::filesystem::path> dems; ///< at least one
    static constexpr std::size_t kMaxImagery = 4;
    std::vector<std::filesystem::path> imagery; ///< kMaxImagery at most
    std::vector<std::filesystem::path> features;
    std::vector<std::filesystem::path> buildings;  ///< drawn by programs that draw buildings
    std::vector<std::filesystem::path> objects;    ///< likewise
    std::vector<std::filesystem::path> structures; ///< likewise
    std::vector<std::filesystem::path> earthworks; ///< what the ground is cut and filled to
    std::filesystem::path landCover;               ///< empty: none
    std::filesystem::path landCoverClasses;        ///< a table's name or file; empty: worldcover
    std::optional<double> seasonOfYear;            ///< 0…1
    std::filesystem::path roads;                   ///< an OpenDRIVE file; empty: none
    std::filesystem::path edits;                   ///< kept by writeEdits(), earthworks included; empty: none
    std::optional<RoadsOrigin> roadsOrigin;        ///< absent: by the network's own georeference
    bool roadsOnGround = false;                    ///< the network's heights count from the smoothed ground
    std::optional<Geodetic> origin;
    Placement placement = Placement::curved;
    DemImportOptions import;
    std::optional<double> finestSpacingM; ///< of samples that edits may add
    Method method = Method::roam;
    double errorTolerancePx = 1.0;
    std::uint32_t maxTriangles = std::numeric_limits<std::uint32_t>::max();
    std::optional<double> viewMarginDeg; ///< absent: refined all around
    std::optional<double> adaptTimeUs;   ///< that a frame may adapt the mesh; absent: no limit
    LandParameters land;
    std::optional<double> sunAzimuthDeg; ///< both sun angles are present, or neither
    std::optional<double> sunElevationDeg;
    std::optional<double> visibilityM;
    std::optional<double> moonlight;
    std::string clouds;       ///< as they stand there, not read; empty: nothing is told
    std::string ground;       ///< the same
    bool showsVoids = false;  ///< colours filled ground
    bool surroundings = true; ///< made-up ground beyond the data
};

/// Parses the text of a .roam file. `name`: its path, for messages and relative paths. Reads no file.
foundation::Result<RoamFile> parseRoamFile(std::string_view text, const std::filesystem::path& name);

/// Reads and parses a .roam file. The files that it names must exist (/vsi names are not checked).
foundation::Result<RoamFile> readRoamFile(const std::filesystem::path& file);

} // namespace osgTerrainROAM::core
