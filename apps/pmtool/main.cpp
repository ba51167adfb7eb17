// SPDX-License-Identifier: Apache-2.0
// pmtool: inspects, cleans and simplifies models.
#include "pmtool/Commands.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terminal/MovedCommand.h"

namespace
{

constexpr terminal::MovedCommand kMoved[] = {{"compare", "compare_objects"},
                                             {"support", "compare_objects support"}};

int run(int argc, char** argv)
{
    if (const auto ends = terminal::answerMoved("pmtool", kMoved, argc, argv)) return *ends;
    CLI::App app("Inspects, cleans and simplifies models of objects.", "pmtool");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    pmtool::Chosen chosen;
    pmtool::addInfo(app, chosen);
    pmtool::addConsolidate(app, chosen);
    pmtool::addBake(app, chosen);
    pmtool::addSimplify(app, chosen);
    pmtool::addBuild(app, chosen);
    pmtool::addTessellate(app, chosen);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terminal::report("pmtool", chosen.jsonFile, chosen.work, chosen.places);
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("pmtool", [=] { return run(argc, argv); });
}
