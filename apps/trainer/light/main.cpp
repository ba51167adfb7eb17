// SPDX-License-Identifier: Apache-2.0
// qualify_light: what `trainer qualify light` becomes.
#include "LightReport.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Measures air, sky, lamps and clouds as they are drawn; fails when a figure fails.",
                 "qualify_light");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    std::filesystem::path jsonFile;
    app.add_option("--json", jsonFile, "JSON file for the figures");
    if (const auto ended = terminal::parse(app, argc, argv)) return *ended;
    return terminal::report("trainer", jsonFile, [] { return trainer::lightReport(); });
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("trainer", [&] { return run(argc, argv); });
}
