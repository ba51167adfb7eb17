// SPDX-License-Identifier: Apache-2.0
// worldtool: makes worlds from elevation data and maps.
#include <algorithm>

#include <foundation/HugeHeap.h>

#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "worldmaking/map/MapSources.h"
#include "worldtool/Commands.h"
#include "worldtool/Processors.h"

namespace worldtool
{

namespace
{

/// Takes elevation rasters that stand behind the values of --map.
void partRasters(Request& request, const CLI::Option& dem)
{
    if (request.dems.empty() && request.maps.size() > 1)
    {
        const auto rasters =
            std::stable_partition(request.maps.begin() + 1, request.maps.end(), worldmaking::isMapName);
        request.dems.assign(rasters, request.maps.end());
        request.maps.erase(rasters, request.maps.end());
    }
    if (request.dems.empty()) throw CLI::RequiredError(dem.get_name());
}

} // namespace

} // namespace worldtool

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Makes worlds from elevation data and maps.", "worldtool");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    worldtool::Request request;
    request.version = OSGTRAINER_VERSION;
    std::filesystem::path jsonFile;
    CLI::App* build = app.add_subcommand("build", "a world with the streets of a map");
    CLI::Option* dem = build->add_option("DEM", request.dems, "elevation rasters; one or more must be given");
    CLI::Option* map =
        build
            ->add_option(
                "--map", request.maps,
                "a map, one or more: .osm, .osm.gz, .osm.bz2, .osm.pbf, .osc …, GeoPackage, GeoJSON, "
                "shapefile, or a folder or .zip of them; without it a map is made up")
            ->type_name("PATH ...");
    build->callback([&] { worldtool::partRasters(request, *dem); });
    build->add_option("--seed", request.seed, "of the map that is made up")->excludes(map);
    build
        ->add_option("--aridity", request.aridity,
                     "of the made-up map: 0 wet and green … 1 desert, instead of that of the place")
        ->check(CLI::Range(0.0, 1.0))
        ->excludes(map);
    build->add_option("-o,--output", request.world, "the folder of the world")->required();
    build
        ->add_option("--bounds", request.bounds,
                     "the part of the map to use: WEST,SOUTH,EAST,NORTH in degrees")
        ->delimiter(',')
        ->expected(4);
    build
        ->add_option("--land-cover", request.landCover,
                     "raster of land cover, for what the map says nothing of")
        ->needs(map);
    build->add_option("--land-cover-classes", request.landCoverClasses,
                      "what its classes mean: worldcover, corine, or a file");
    build->add_option("--jobs", request.jobs, "processors to use at most")->check(CLI::Range(1, 1024));
    build->add_option("--runways", request.runways, "runways as OurAirports lists them: .csv");
    build->add_option("--json", jsonFile, "also write the report to this file");
    std::filesystem::path checked;
    CLI::App* check = app.add_subcommand("check", "looks for what stands wrong in a world");
    check->add_option("WORLD", checked, "the folder of a world, or a .roam file")->required();
    check->add_option("--json", jsonFile, "also write the report to this file");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terminal::report(
        "worldtool", jsonFile,
        [&]
        {
            worldtool::limitProcessors(request.jobs);
            return check->parsed() ? worldtool::check(checked) : worldtool::build(request);
        },
        check->parsed() ? terminal::Places() : worldtool::placesOf(request));
}

} // namespace

int main(int argc, char** argv)
{
    foundation::growHeapInHugePages();
    return terminal::guarded("worldtool", [=] { return run(argc, argv); });
}
