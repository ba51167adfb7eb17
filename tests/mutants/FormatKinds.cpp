// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <utility>

#include "Kinds.h"
#include "Seeds.h"

namespace
{

/// What a world has besides streets.
const char* const kThings = R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"building": "house", "height": "7"}, "geometry": {"type": "Polygon", "coordinates":
  [[[1.5005,42.5005],[1.5007,42.5005],[1.5007,42.5006],[1.5005,42.5006],[1.5005,42.5005]]]}},
 {"type": "Feature", "properties": {"natural": "wood"}, "geometry": {"type": "Polygon", "coordinates":
  [[[1.497,42.502],[1.5,42.502],[1.5,42.504],[1.497,42.502]]]}},
 {"type": "Feature", "properties": {"natural": "water"}, "geometry": {"type": "Polygon", "coordinates":
  [[[1.496,42.496],[1.497,42.496],[1.497,42.497],[1.496,42.496]]]}},
 {"type": "Feature", "properties": {"barrier": "fence"}, "geometry": {"type": "LineString", "coordinates":
  [[1.497,42.4995],[1.499,42.4995]]}},
 {"type": "Feature", "properties": {"aeroway": "runway", "ref": "09/27", "width": "20"}, "geometry": {"type": "LineString",
  "coordinates": [[1.494,42.506],[1.503,42.506]]}}]})";

/// Makes files by the programs themselves; none where that fails.
class MadeSeeds
{
public:
    explicit MadeSeeds(const MutantFolders& folders)
        : _folders(folders), _ground((folders.corpus() / "place.tif").string())
    {
        const auto things = seeds::written(folders.scratch / "things.geojson", kThings);
        run(folders.command("worldtool",
                            {"build", _ground, "--map", (folders.corpus() / "village.osm").string(), "--map",
                             things.string(), "-o", folders.made("village")}));
        run(folders.command("trainer", {"play", (folders.corpus() / "story.xosc").string(), "--headless",
                                        "--duration", "0.2", "--csv_logger", folders.made("motion.csv")}));
    }

    /// Files in the folder of the world, or beside it.
    seeds::Files in(std::initializer_list<const char*> names) const
    {
        seeds::Files files;
        std::error_code none;
        for (const char* name : names)
            if (std::filesystem::exists(_folders.scratch / name, none))
                files.push_back(_folders.scratch / name);
        return files;
    }

    const std::string& ground() const { return _ground; }

private:
    static void run(const Command& words)
    {
        std::string line;
        for (const std::string& word : words)
            line += "'" + word + "' ";
        (void)!std::system((line + "> /dev/null 2>&1").c_str()); // files that are missing are told
    }

    MutantFolders _folders;
    std::string _ground;
};

/// Files that the last line of a .roam file names; lines before it may stand in `key`.
InputKind ofRoam(const MutantFolders& folders, const MadeSeeds& made, const std::string& name,
                 seeds::Files files, const std::string& key)
{
    return {name, std::move(files),
            [folders, ground = made.ground(), name, key](const std::string& file) -> std::vector<Command>
            {
                const auto world =
                    seeds::written(folders.scratch / ("of-" + name + ".roam"),
                                   "dem = " + ground + "\nfinest_spacing = 3\n" + key + " = " + file + "\n");
                return {folders.command(
                    "trainer", {"tour", "--no-world", world.string(), "--size", "64x36", "--frames", "1"})};
            }};
}

InputKind ofMap(const MutantFolders& folders, const MadeSeeds& made, const std::string& name,
                seeds::Files files)
{
    return {name, std::move(files),
            [folders, ground = made.ground()](const std::string& file) -> std::vector<Command>
            {
                return {folders.command(
                    "worldtool", {"build", ground, "--map", file, "-o", folders.made("world-of-format")})};
            }};
}

} // namespace

std::vector<InputKind> formatKinds(const MutantFolders& folders)
{
    const auto corpus = folders.corpus();
    const MadeSeeds made(folders);
    return {ofMap(folders, made, "pbf", {corpus / "village.osm.pbf"}),
            ofMap(folders, made, "gpkg", made.in({"village/buildings.gpkg", "village/ground.gpkg"})),
            ofMap(folders, made, "shp", {corpus / "land.shz"}),
            ofMap(folders, made, "map-zip", {corpus / "village.zip"}),
            ofRoam(folders, made, "features", made.in({"village/ground.gpkg"}), "features"),
            ofRoam(folders, made, "buildings", made.in({"village/buildings.gpkg"}), "buildings"),
            ofRoam(folders, made, "structures", made.in({"village/structures.gpkg"}), "structures"),
            ofRoam(folders, made, "objects", made.in({"village/trees.gpkg"}), "objects"),
            ofRoam(folders, made, "earthworks", made.in({"village/earthworks.gpkg"}), "earthworks"),
            ofRoam(folders, made, "edits", made.in({"village/ground.edits"}),
                   "roads = " + folders.made("village/roads.xodr") + "\nroads_heights = file\nearthworks = " +
                       folders.made("village/earthworks.gpkg") + "\nedits"),
            ofRoam(folders, made, "cover", made.in({"village/landcover.tif"}), "land_cover"),
            ofRoam(folders, made, "imagery", {corpus / "place.tif"}, "imagery"),
            {"motion", made.in({"motion.csv"}),
             [folders](const std::string& file) -> std::vector<Command>
             {
                 return {folders.command("trainer", {"compare", file, folders.made("motion.csv")}),
                         folders.command("trainer", {"compare", folders.made("motion.csv"), file})};
             }}};
}
