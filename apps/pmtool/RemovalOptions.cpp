// SPDX-License-Identifier: Apache-2.0
#include "pmtool/RemovalOptions.h"

#include <map>
#include <string>

#include <osgPMObjects/core/simplify/CollapsesOfRemovals.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "terminal/CommandLine.h"

namespace pmtool
{

using namespace osgPMObjects;

void addRemovalOptions(CLI::App& command, RemovalRequest& request)
{
    const std::map<std::string, core::SupportRule> rules = {{"none", core::SupportRule::none},
                                                            {"max", core::SupportRule::farthest},
                                                            {"both", core::SupportRule::farthestAndNearest}};
    command
        .add_option(
            "--support", request.support,
            "removal: vertices that stay, of each cell of an octree: none (default); max: the farthest "
            "from its centre; both: the farthest and the nearest")
        ->transform(terminal::named(rules));
    command
        .add_option("--support-depth", request.octreeDepth,
                    "removal: depth of the octree, 2^depth cells along each axis (3)")
        ->check(terminal::between(0, 10));
}

core::CollapseSequence removalsOf(const core::Mesh& mesh, const RemovalRequest& request)
{
    core::RemovalOptions options{.triangulation = core::HoleTriangulation::fan};
    if (request.support != core::SupportRule::none)
        options.isSupport =
            core::supportVertices(mesh, core::OctreeDivisions::ofDepth(request.octreeDepth), request.support);
    return core::collapsesOf(mesh, core::removeVertices(mesh, options));
}

} // namespace pmtool
