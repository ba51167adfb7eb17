// SPDX-License-Identifier: Apache-2.0
#include "Command.h"

#include <cinttypes>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "Terrain.h"
#include "TerrainFile.h"
#include "course/CourseFile.h"
#include "course/CourseSearch.h"

namespace islandgen
{

namespace
{

int fail(const foundation::Error& error, int exitCode)
{
    std::fprintf(stderr, "generate_terrain: %s\n", error.message().c_str());
    return exitCode;
}

foundation::Outcome checkHash(std::uint64_t seed, int side, std::uint64_t hash)
{
    const auto expected = expectedHash(seed, side);
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

/// The place around which the course is searched: gentle land at the foot of the range.
constexpr glm::dvec2 kCourseMiddleM(1700.0, -900.0);
constexpr double kCourseStepM = 5.0, kCourseSmoothM = 100.0;

foundation::Outcome makeCourse(const Terrain& terrain, std::uint64_t seed, const std::string& file)
{
    const auto course = searchCourse(terrain, kCourseMiddleM, seed);
    if (!course)
        return foundation::Error{"--course", "no closed course fits this land",
                                 "try another seed or a larger size"};
    const auto heights = courseHeights(terrain, *course, kCourseStepM, kCourseSmoothM);
    std::printf("%s: %.0f m, %zu bends\n", file.c_str(), course->lengthM, course->bends.size());
    return writeCourse(terrain, *course, heights, file);
}

int run(int argc, char** argv, const char* version)
{
    CLI::App app{"Makes the default terrain: an island with coast, plain, hills and mountains, and a course "
                 "of roads."};
    std::string output, courseFile;
    std::uint64_t seed = kDefaultSeed;
    int side = kDefaultSide;
    bool check = false;
    app.add_option("-o,--output", output, "the GeoTIFF to write")->required();
    app.add_option("--seed", seed, "another number, another island")->capture_default_str();
    app.add_option("--size", side, "samples along each side, a power of two plus one")->capture_default_str();
    app.add_option("--course", courseFile, "a road network to write: a closed course, OpenDRIVE");
    app.add_flag("--check-hash", check, "fail when the heights are not the committed ones");
    app.set_version_flag("--version", version);
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        if (error.get_exit_code() == 0) return app.exit(error);
        return fail({"command line", error.what(), "see generate_terrain --help"}, 2);
    }

    auto terrain = generateTerrain(seed, side);
    if (!terrain) return fail(terrain.error(), 2);
    const std::uint64_t hash = terrainHash(terrain->heightM);
    if (check)
    {
        const auto checked = checkHash(seed, side, hash);
        if (!checked) return fail(checked.error(), 1);
    }
    const auto written = writeTerrain(*terrain, output);
    if (!written) return fail(written.error(), 1);
    std::printf("%s: %d x %d samples, seed %" PRIu64 ", hash %016" PRIx64 "\n", output.c_str(), side, side,
                seed, hash);
    if (courseFile.empty()) return 0;
    const auto made = makeCourse(*terrain, seed, courseFile);
    return made ? 0 : fail(made.error(), 1);
}

} // namespace

int runCommand(int argc, char** argv, const char* version)
{
    try
    {
        return run(argc, argv, version);
    }
    catch (const std::exception& error)
    {
        // Not enough memory for a large --size.
        std::fprintf(stderr, "generate_terrain: %s; try a smaller --size\n", error.what());
        return 1;
    }
}

} // namespace islandgen
