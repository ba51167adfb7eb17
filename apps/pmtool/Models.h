// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osgPMObjects/core/mesh/MeshCounts.h>

#include <osgPMObjects/ReadModel>

#include "pmtool/Commands.h"

namespace pmtool
{

/// Which models, and what reading them may take.
struct ModelRequest
{
    std::vector<std::string> files;
    osgPMObjects::ReadLimits limits;
};

/// Declares MODEL…, --json and the limits.
void addModelOptions(CLI::App& command, ModelRequest& request, std::filesystem::path& jsonFile);

/// A model as it came from its file.
struct ReadModel
{
    osgPMObjects::ImportedModel imported;
    std::vector<std::string> notes; ///< the file's own descriptions, and what its reader left out
};

/// Reads a model in a child process, and imports it. Errors: as readModelNode() and importNode().
foundation::Result<ReadModel> read(const std::string& file, const osgPMObjects::ReadLimits& limits);

/// The same, ready to be simplified (makeSimplifiable()). Errors: as read(); no triangles are left.
struct CleanModel
{
    ReadModel read;
    std::size_t trianglesRead = 0; ///< before
};
foundation::Result<CleanModel> readClean(const std::string& file, const osgPMObjects::ReadLimits& limits);

/// Calls `work` for each model; it adds a row to the table's "models", or says what went wrong: then that is printed, the other
/// models are done all the same, and the table is not sound.
foundation::Result<terminal::Report>
forEachModel(const ModelRequest& request,
             const std::function<foundation::Result<nlohmann::ordered_json>(const std::string& file)>& work);

/// Counts under the names that the tables have for them.
nlohmann::ordered_json tableOf(const osgPMObjects::core::MeshCounts& counts);

/// What an import met, by name; what it did not meet is left out.
nlohmann::ordered_json tableOf(const osgPMObjects::ImportReport& report);

} // namespace pmtool
