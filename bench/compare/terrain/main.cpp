// SPDX-License-Identifier: Apache-2.0
// compare_terrain: measures methods of level of detail for terrain, and the drivers of ROAM, side by side.
#include "compare/terrain/Chosen.h"
#include "compare/terrain/drivers/AddDrivers.h"
#include "compare/terrain/methods/AddMethods.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Measures ways to refine terrain side by side.", "compare_terrain");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    terraintool::Chosen chosen;
    terraintool::addMethods(app, chosen);
    terraintool::addDrivers(app, chosen);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terminal::report("compare_terrain", chosen.jsonFile, chosen.work);
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("compare_terrain", [=] { return run(argc, argv); });
}
