// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <foundation/Result.h>

#include "terminal/CommandLine.h"
#include "terminal/Places.h"
#include "terminal/Report.h"

// docs/reference/json-tables.md has the layout of every table.
namespace pmtool
{

/// The work that the command line asked for. Each add…() declares one subcommand; the callback of the chosen one sets `work`.
struct Chosen
{
    std::function<foundation::Result<terminal::Report>()> work;
    std::filesystem::path jsonFile;
    terminal::Places places{}; ///< that are checked before the work
};

/// Declares `info`: prints what is in each model or progressive mesh.
void addInfo(CLI::App& app, Chosen& chosen);

/// Declares `consolidate`: repairs each model, counts before and after, and writes the result.
void addConsolidate(CLI::App& app, Chosen& chosen);

/// Declares `build`: makes a progressive mesh of a model, a `.pm` file.
void addBuild(CLI::App& app, Chosen& chosen);

/// Declares `bake`: simplifies each model and keeps its appearance in colour and normal maps.
void addBake(CLI::App& app, Chosen& chosen);

/// Declares `simplify`: makes levels with fewer triangles, by count or by error.
void addSimplify(CLI::App& app, Chosen& chosen);

/// Declares `support`: measures how the area changes as vertices are removed, with support vertices and without.
void addSupport(CLI::App& app, Chosen& chosen);

/// Declares `tessellate`: cuts polygons into triangles or convex pieces.
void addTessellate(CLI::App& app, Chosen& chosen);

/// Declares `compare`, and returns it for the comparisons.
CLI::App* addCompareGroup(CLI::App& app);

/// Declares `compare order`: measures every order of triangles on every model.
void addCompareOrder(CLI::App& compare, Chosen& chosen);

/// Declares `compare cache`: measures every arrangement of the faces of progressive meshes on every model.
void addCompareCache(CLI::App& compare, Chosen& chosen);

/// Declares `compare simplify`: measures every simplifier on every model.
void addCompareSimplify(CLI::App& compare, Chosen& chosen);

/// Declares `compare silhouette`: measures images of levels from all around on every model.
void addCompareSilhouette(CLI::App& compare, Chosen& chosen);

/// Declares `compare tolerance`: measures how many triangles progressive objects show at a tolerance, and how few would keep it.
void addCompareTolerance(CLI::App& compare, Chosen& chosen);

} // namespace pmtool
