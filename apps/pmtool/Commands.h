// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <foundation/Result.h>

#include "terminal/CommandLine.h"
#include "terminal/Report.h"

namespace pmtool
{

/// What the command line asked for. Each add…() declares one subcommand with its options, which live in its callback; the
/// one that is chosen puts its work here.
struct Chosen
{
    std::function<foundation::Result<terminal::Report>()> work;
    std::filesystem::path jsonFile;
};

/// `info`: what is in each model, or progressive mesh.
void addInfo(CLI::App& app, Chosen& chosen);

/// `consolidate`: cleans each model, counts before and after, writes what came out.
void addConsolidate(CLI::App& app, Chosen& chosen);

/// `build`: makes a progressive mesh of a model, a `.pm` file. docs/reference/json-tables.md has the layout of the table.
void addBuild(CLI::App& app, Chosen& chosen);

/// `bake`: simplifies each model and keeps its looks in maps. docs/reference/json-tables.md has the layout of the table.
void addBake(CLI::App& app, Chosen& chosen);

/// `simplify`: levels with fewer triangles, by count or by error.
void addSimplify(CLI::App& app, Chosen& chosen);

/// `support`: area against faces as vertices are removed, with support vertices and without. docs/reference/json-tables.md has the
/// layout of the table.
void addSupport(CLI::App& app, Chosen& chosen);

/// `compare`, to which the comparisons are added.
CLI::App* addCompareGroup(CLI::App& app);

/// `compare order`: every order of triangles on every model. docs/reference/json-tables.md has the layout of the table.
void addCompareOrder(CLI::App& compare, Chosen& chosen);

/// `compare cache`: every way to keep the faces of progressive meshes in order, on every model. docs/reference/json-tables.md has
/// the layout of the table.
void addCompareCache(CLI::App& compare, Chosen& chosen);

/// `compare simplify`: every way to simplify on every model. docs/reference/json-tables.md has the layout of the table.
void addCompareSimplify(CLI::App& compare, Chosen& chosen);

} // namespace pmtool
