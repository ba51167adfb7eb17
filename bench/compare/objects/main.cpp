// SPDX-License-Identifier: Apache-2.0
// compare_objects: measures algorithms for models side by side.
#include "compare/objects/Commands.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Measures algorithms for models of objects side by side.", pmtool::kComparer);
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    pmtool::Chosen chosen;
    pmtool::addCompareOrder(app, chosen);
    pmtool::addCompareCache(app, chosen);
    pmtool::addCompareSimplify(app, chosen);
    pmtool::addCompareSilhouette(app, chosen);
    pmtool::addCompareTolerance(app, chosen);
    pmtool::addSupport(app, chosen);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terminal::report(pmtool::kComparer, chosen.jsonFile, chosen.work, chosen.places);
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded(pmtool::kComparer, [=] { return run(argc, argv); });
}
