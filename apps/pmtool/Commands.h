// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <foundation/Result.h>

#include "terminal/Places.h"
#include "terminal/Report.h"

namespace CLI
{
class App;
}

// docs/reference/json-tables.md has the layout of every table.
namespace pmtool
{

/// The work that the command line asked for. Each add…() declares one subcommand; the callback of the chosen
/// one sets `work`.
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

/// Declares `tessellate`: cuts polygons into triangles or convex pieces.
void addTessellate(CLI::App& app, Chosen& chosen);

} // namespace pmtool
