// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "Kinds.h"
#include "Seeds.h"

namespace
{

/// Makes the kinds; holds the terrain that their commands share.
class WorldKinds
{
public:
    explicit WorldKinds(const MutantFolders& folders)
        : _folders(folders),
          _hill(seeds::written(folders.scratch / "hill.asc", seeds::hillGrid()).string()),
          _geoHill(seeds::written(folders.scratch / "geo-hill.asc",
                                  seeds::hillGrid("xllcorner 1.49\nyllcorner 42.49\ncellsize 0.00075\n"))
                       .string())
    {
        seeds::written(
            folders.scratch / "geo-hill.prj",
            R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["Degree",0.0174532925199433]])");
    }

    InputKind terrains(const std::string& name, seeds::Files files) const
    {
        return {name, std::move(files), [maker = *this](const std::string& file) -> std::vector<Command> {
                    return {maker._folders.command("terraintool", {"info", file}), maker.tour(file, {})};
                }};
    }

    /// Files that an option of a tour names.
    InputKind ofTour(const std::string& name, seeds::Files files, const std::string& option) const
    {
        return {name, std::move(files),
                [maker = *this, option](const std::string& file) -> std::vector<Command> {
                    return {maker.tour(maker._hill, {option, file})};
                }};
    }

    InputKind roads(seeds::Files files) const
    {
        return {"xodr", std::move(files),
                [folders = _folders](const std::string& file) -> std::vector<Command>
                {
                    return {
                        folders.command("roadtool", {"info", file}),
                        folders.command("roadtool", {"validate", file}),
                        folders.command("roadtool", {"draw", file, "--svg", folders.made("roads.svg"),
                                                     "--png", folders.made("roads.png"), "--pixels", "200"})};
                }};
    }

    InputKind maps(const std::string& name, seeds::Files files) const
    {
        return {name, std::move(files), [maker = *this](const std::string& file) -> std::vector<Command> {
                    return {maker.world({"--map", file})};
                }};
    }

    /// Changes of a map that is whole.
    InputKind changes(seeds::Files files) const
    {
        return {
            "osc", std::move(files),
            [maker = *this](const std::string& file) -> std::vector<Command>
            {
                const auto map = maker._folders.corpus() / "village.osm";
                return {maker.world({"--map", map.string(), "--map", file}), maker.world({"--map", file})};
            }};
    }

    /// Runways stand beside a map that is whole.
    InputKind runways(seeds::Files files) const
    {
        return {"runways", std::move(files),
                [maker = *this](const std::string& file) -> std::vector<Command>
                {
                    const auto map = maker._folders.corpus() / "village.osm";
                    return {maker.world({"--map", map.string(), "--runways", file})};
                }};
    }

private:
    Command tour(const std::string& terrain, const Command& more) const
    {
        Command words = {"tour", "--no-world", terrain, "--size", "64x36", "--frames", "1"};
        words.insert(words.end(), more.begin(), more.end());
        return _folders.command("trainer", words);
    }

    Command world(const Command& more) const
    {
        Command words = {"build", _geoHill, "-o", _folders.made("world")};
        words.insert(words.end(), more.begin(), more.end());
        return _folders.command("worldtool", words);
    }

    MutantFolders _folders;
    std::string _hill, _geoHill;
};

const char* const kView = R"(<View layout="tiled">
  <Channel name="a" widthPx="64" heightPx="36" fovXDeg="60" yawDeg="-30"/>
  <Channel name="b" widthPx="64" heightPx="36"><Frustum leftDeg="-20" rightDeg="35" bottomDeg="-15" topDeg="25"/></Channel>
</View>
)";

const char* const kScenery =
    R"({"seed": 3, "fields": [{"name": "a", "arrangement": "scattered", "count": 4, "objects": [{"kind": "barn"}],
 "where": {"circle": {"eastM": 400, "northM": 400, "radiusM": 300}}}]})";

const char* const kRunways =
    R"("id","airport_ref","airport_ident","length_ft","width_ft","surface","lighted","closed","le_ident","le_latitude_deg","le_longitude_deg","le_elevation_ft","le_heading_degT","le_displaced_threshold_ft","he_ident","he_latitude_deg","he_longitude_deg","he_elevation_ft","he_heading_degT","he_displaced_threshold_ft"
1,2,"XXXX",2000,75,"ASP",0,0,"09",42.508,1.498,3000,90,,"27",42.508,1.506,3000,270,
)";

const char* const kLand = R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"building": "house", "height": "7"}, "geometry": {"type": "Polygon", "coordinates":
  [[[1.5,42.5],[1.5002,42.5],[1.5002,42.5001],[1.5,42.5001],[1.5,42.5]]]}},
 {"type": "Feature", "properties": {"natural": "wood"}, "geometry": {"type": "Polygon", "coordinates":
  [[[1.501,42.501],[1.504,42.501],[1.504,42.503],[1.501,42.501]]]}},
 {"type": "Feature", "properties": {"highway": "residential", "name": "Road"}, "geometry": {"type": "LineString",
  "coordinates": [[1.4995,42.4995],[1.5015,42.5],[1.504,42.501]]}},
 {"type": "Feature", "properties": {"waterway": "stream"}, "geometry": {"type": "LineString", "coordinates":
  [[1.498,42.498],[1.499,42.501],[1.502,42.504]]}}]})";

} // namespace

std::vector<InputKind> worldKinds(const MutantFolders& folders)
{
    using seeds::joined, seeds::realFiles, seeds::written;
    const WorldKinds make(folders);
    const auto corpus = folders.corpus();
    const seeds::Files hill = {folders.scratch / "hill.asc", corpus / "place.tif"};
    return {
        make.terrains("dem", joined(hill, realFiles(folders.real("dem"),
                                                    {".asc", ".tif", ".hgt", ".dt0", ".gz", ".zip"}))),
        make.terrains("roam", {written(folders.scratch / "hill.roam", "dem = hill.asc\n")}),
        make.ofTour("scenery", {written(folders.scratch / "scenery.json", kScenery)}, "--scenery"),
        make.ofTour("view", {written(folders.scratch / "view.xml", kView)}, "--view"),
        make.roads(joined({corpus / "curves.xodr", corpus / "junction.xodr", corpus / "latin.xodr"},
                          realFiles(folders.real("openscenario"), {".xodr"}))),
        make.maps("osm", {corpus / "village.osm"}),
        make.maps("josm", {corpus / "josm.osm"}),
        make.changes({corpus / "edit.osc"}),
        make.maps("geojson", {written(folders.scratch / "land.geojson", kLand), corpus / "frame.geojson"}),
        make.runways({written(folders.scratch / "runways.csv", kRunways)})};
}
