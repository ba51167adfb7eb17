// SPDX-License-Identifier: Apache-2.0
// terraintool: looks into elevation files and checks what the ROAM engine makes of them.
#include <exception>
#include <functional>

#include <CLI/CLI.hpp>

#include "terminal/Terminal.h"
#include "terraintool/Commands.h"

namespace
{

using Command = std::function<viewlod::Result<terraintool::Report>(const terraintool::Request&)>;

int run(const Command& command, const terraintool::Request& request, const std::string& jsonFile)
{
    const auto report = command(request);
    if (!report) return terminal::fail("terraintool", report.error());
    if (!jsonFile.empty())
        if (const auto written = terminal::writeFile(jsonFile, report->json.dump(2) + "\n"); !written)
            return terminal::fail("terraintool", written.error());
    return report->sound ? terminal::kDone : terminal::kFailed;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Inspects elevation files and validates the terrain drawn from them.", "terraintool");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    terraintool::Request request;
    std::string jsonFile;
    Command command;
    const auto add = [&](const char* name, const char* what, Command action)
    {
        CLI::App* sub = app.add_subcommand(name, what);
        sub->add_option("FILE", request.files, ".roam files or elevation rasters")->required();
        sub->add_option("--json", jsonFile, "write the table there, too");
        sub->add_option("--spacing", request.import.spacingM,
                        "metres between samples of a raster without georeference")
            ->check(CLI::PositiveNumber);
        sub->callback([&command, action] { command = action; });
        return sub;
    };
    add("info", "size, heights, voids and placement", terraintool::info);
    CLI::App* validate =
        add("validate", "fly the tour and check every mesh by brute force", terraintool::validate);
    validate->add_option("--frames", request.frames, "frames of the flight")->check(CLI::PositiveNumber);
    validate->add_option("--tolerance", request.tolerancePx, "error target in pixels")
        ->check(CLI::PositiveNumber);
    validate->add_option("--max-triangles", request.maxTriangles, "triangle ceiling")
        ->check(CLI::Range(2u, 100000000u));
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? terminal::kDone : terminal::kWrongUse;
    }
    return run(command, request, jsonFile);
}
