// SPDX-License-Identifier: Apache-2.0
// generate_terrain: makes the default terrain. See data/README.md.
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "Terrain.h"
#include "TerrainFile.h"

namespace
{

int fail(const foundation::Error& error, int exitCode)
{
    std::fprintf(stderr, "generate_terrain: %s\n", error.message().c_str());
    return exitCode;
}

foundation::Outcome checkHash(std::uint64_t seed, int side, std::uint64_t hash)
{
    const auto expected = islandgen::expectedHash(seed, side);
    if (!expected)
    {
        return foundation::Error{"--check-hash", "no hash is committed for this seed and size",
                                 "leave the option out, or use the default seed and size"};
    }
    if (*expected != hash)
    {
        char text[64];
        std::snprintf(text, sizeof text, "is %016" PRIx64 ", not %016" PRIx64, hash, *expected);
        return foundation::Error{
            "hash of the terrain", text,
            "build with -ffp-contract=off and without -ffast-math, or commit the new hash"};
    }
    return foundation::success();
}

int run(int argc, char** argv)
{
    CLI::App app{"Makes the default terrain: an island with coast, plain, hills and mountains."};
    std::string output;
    std::uint64_t seed = islandgen::kDefaultSeed;
    int side = islandgen::kDefaultSide;
    bool check = false;
    app.add_option("-o,--output", output, "the GeoTIFF to write")->required();
    app.add_option("--seed", seed, "another number, another island")->capture_default_str();
    app.add_option("--size", side, "samples along each side, a power of two plus one")->capture_default_str();
    app.add_flag("--check-hash", check, "fail when the heights are not the committed ones");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        if (error.get_exit_code() == 0) return app.exit(error);
        return fail({"command line", error.what(), "see generate_terrain --help"}, 2);
    }

    auto terrain = islandgen::generateTerrain(seed, side);
    if (!terrain) return fail(terrain.error(), 2);
    const std::uint64_t hash = islandgen::terrainHash(terrain->heightM);
    if (check)
    {
        const auto checked = checkHash(seed, side, hash);
        if (!checked) return fail(checked.error(), 1);
    }
    const auto written = islandgen::writeTerrain(*terrain, output);
    if (!written) return fail(written.error(), 1);
    std::printf("%s: %d x %d samples, seed %" PRIu64 ", hash %016" PRIx64 "\n", output.c_str(), side, side,
                seed, hash);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const std::exception& error)
    {
        // Not enough memory for a large --size.
        std::fprintf(stderr, "generate_terrain: %s; try a smaller --size\n", error.what());
        return 1;
    }
}
