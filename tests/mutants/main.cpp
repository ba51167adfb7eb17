// SPDX-License-Identifier: Apache-2.0
// mutants: damages every kind of input in many ways and runs the programs on it. None may die of a signal,
// take more than 30 s or more than 2 GB of memory, or fail without a word.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "Kinds.h"
#include "LimitedRun.h"
#include "Mutation.h"

namespace
{

struct Request
{
    MutantFolders folders;
    std::uint32_t count = 3, first = 0;
    std::vector<std::string> kinds;
    RunLimits limits;
    bool isControl = false;
};

std::string bytesOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string lineOf(const std::vector<std::string>& command)
{
    std::string line;
    for (const std::string& word : command)
        line += (line.empty() ? "" : " ") + word;
    return line;
}

/// What the runs of one kind had in common.
struct Tally
{
    std::size_t runs = 0, refused = 0, faults = 0;
    double seconds = 0.0, memoryMiB = 0.0; ///< of the worst run

    void add(const LimitedRun& run)
    {
        ++runs;
        refused += run.exitCode != 0;
        seconds = std::max(seconds, run.seconds);
        memoryMiB = std::max(memoryMiB, run.memoryMiB);
    }
};

/// Runs one mutant; keeps it, and says how to repeat it, where something is wrong.
void runMutant(const Request& request, const InputKind& kind, std::uint32_t number, Tally& tally)
{
    const std::filesystem::path& seed = kind.seeds[number % kind.seeds.size()];
    const std::string name = kind.name + "-" + std::to_string(number) + "-" + seed.filename().string();
    const std::filesystem::path file = request.folders.scratch / name;
    std::string bytes = mutated(bytesOf(seed), number);
    if (kind.repair && number % 2 == 0) kind.repair(bytes);
    std::ofstream(file, std::ios::binary) << bytes;
    const auto commands = kind.commands(file.string());
    const auto& command = commands[number / kind.seeds.size() % commands.size()];
    const LimitedRun run = runLimited(command, request.limits);
    tally.add(run);
    const std::string fault = run.fault(request.limits);
    if (fault.empty())
    {
        std::filesystem::remove(file);
        return;
    }
    ++tally.faults;
    std::cout << "FAULT " << fault << ": " << lineOf(command) << '\n'
              << (run.errors.empty() ? "" : "  " + run.errors.substr(0, 300) + "\n") << std::flush;
}

std::size_t runKinds(const Request& request)
{
    std::size_t faults = 0;
    for (const InputKind& kind : inputKinds(request.folders))
    {
        if (!request.kinds.empty() &&
            std::find(request.kinds.begin(), request.kinds.end(), kind.name) == request.kinds.end())
            continue;
        if (kind.seeds.empty())
        {
            std::cout << kind.name << ": NOT TESTED: no file to damage (OSGTRAINER_REAL_DATA)\n";
            continue;
        }
        Tally tally;
        for (std::uint32_t i = 0; i < request.count; ++i)
            runMutant(request, kind, request.first + i, tally);
        std::cout << kind.name << ": " << tally.runs << " mutants, " << tally.refused << " refused, at most "
                  << tally.seconds << " s and " << tally.memoryMiB << " MiB, " << tally.faults << " faults\n"
                  << std::flush;
        faults += tally.faults;
    }
    return faults;
}

/// Programs that do what none may do: each must be found out.
std::size_t undetected()
{
    const RunLimits limits{.seconds = 2.0, .memoryMiB = 64.0};
    const std::vector<std::pair<const char*, std::string>> bad = {
        {"died of signal 11", "kill -SEGV $$"},
        {"died of signal 6", "kill -ABRT $$"},
        {"not done after", "sleep 60"},
        {"took", "head -c 100000000 /dev/zero | tail"},
        {"exit code 3", "exit 3"},
        {"without a word", "exit 1"}};
    std::size_t missed = 0;
    for (const auto& [fault, script] : bad)
    {
        const LimitedRun run = runLimited({"sh", "-c", script}, limits);
        const bool isFound = run.fault(limits).find(fault) != std::string::npos;
        missed += !isFound;
        std::cout << (isFound ? "found: " : "MISSED: ") << script << " (" << run.fault(limits) << ")\n";
    }
    const LimitedRun good =
        runLimited({"sh", "-c", "echo 'file: is damaged; copy it again' >&2; exit 1"}, limits);
    if (!good.fault(limits).empty()) std::cout << "ACCUSED: " << good.fault(limits) << '\n';
    return missed + !good.fault(limits).empty();
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Damages every kind of input and runs the programs on it.", "mutants");
    Request request;
    app.add_option("--programs", request.folders.programs,
                   "folder of trainer, terraintool, pmtool, roadtool and worldtool");
    app.add_option("--source", request.folders.source, "folder of this project's source");
    app.add_option("--scratch", request.folders.scratch, "folder for mutants; faulty ones are kept there");
    app.add_option("--count", request.count, "mutants of each kind (3)");
    app.add_option("--first", request.first, "number of the first mutant (0)");
    app.add_option(
        "--kinds", request.kinds,
        "only these kinds: obj, ac, glb, gltf, pm, dem, roam, scenery, view, xosc, xodr, osm, josm, osc, "
        "geojson, runways, aircraft, vehicle, tracks, foreign-tracks, inputs, keys, devices, polygons, mt, "
        "tin, points, pbf, gpkg, shp, map-zip, features, buildings, structures, objects, earthworks, edits, "
        "cover, imagery, motion");
    app.add_flag("--control", request.isControl,
                 "run programs that crash, hang or eat memory, which must be found out");
    CLI11_PARSE(app, argc, argv);
    if (request.isControl) return undetected() == 0 ? 0 : 1;
    if (const char* real = std::getenv("OSGTRAINER_REAL_DATA")) request.folders.realData = real;
    std::filesystem::create_directories(request.folders.scratch);
    return runKinds(request) == 0 ? 0 : 1;
}
