// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pmtool/Commands.h"

// docs/reference/json-tables.md has the layout of every table.
namespace pmtool
{

/// Errors of the commands begin with this name.
inline constexpr const char* kComparer = "compare_objects";

/// Declares `order`: measures every order of triangles on every model.
void addCompareOrder(CLI::App& app, Chosen& chosen);

/// Declares `cache`: measures every arrangement of the faces of progressive meshes on every model.
void addCompareCache(CLI::App& app, Chosen& chosen);

/// Declares `simplify`: measures every simplifier on every model.
void addCompareSimplify(CLI::App& app, Chosen& chosen);

/// Declares `silhouette`: measures images of levels from all around on every model.
void addCompareSilhouette(CLI::App& app, Chosen& chosen);

/// Declares `tolerance`: measures how many triangles progressive objects show at a tolerance, and how few
/// would keep it.
void addCompareTolerance(CLI::App& app, Chosen& chosen);

/// Declares `support`: measures how the area changes as vertices are removed, with support vertices and
/// without.
void addSupport(CLI::App& app, Chosen& chosen);

} // namespace pmtool
