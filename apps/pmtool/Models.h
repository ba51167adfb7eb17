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

/// The models of a command, and the limits of reading them.
struct ModelRequest
{
    std::vector<std::string> files;
    osgPMObjects::ReadLimits limits;
};

/// Declares --json.
void addJsonOption(CLI::App& command, std::filesystem::path& jsonFile);

/// Declares MODEL…, --json and the limits.
void addModelOptions(CLI::App& command, ModelRequest& request, std::filesystem::path& jsonFile);

/// A model as it came from its file.
struct ReadModel
{
    osgPMObjects::ImportedModel imported;
    std::vector<std::string> notes; ///< the file's own descriptions, and what its reader left out
};

/// Reads a model in a child process, and imports it. `prepare`, where it is given, may change the node before
/// it is imported.
/// Errors: as readModelNode() and importNode().
foundation::Result<ReadModel> read(const std::string& file, const osgPMObjects::ReadLimits& limits,
                                   const std::function<void(osg::Node&)>& prepare = {});

/// A model that is ready to be simplified (makeSimplifiable()).
struct CleanModel
{
    ReadModel read;
    std::size_t trianglesRead = 0; ///< before
};

/// Reads and cleans a model. Errors: as read(); no triangles are left.
foundation::Result<CleanModel> readClean(const std::string& file, const osgPMObjects::ReadLimits& limits);

/// Calls `work` for each file and adds the row that it returns to the table's "models". An error is printed,
/// as one of `program`; then the other files are done all the same, and the table is not sound.
foundation::Result<terminal::Report>
forEachModel(const std::vector<std::string>& files,
             const std::function<foundation::Result<nlohmann::ordered_json>(const std::string& file)>& work,
             const std::string& program = "pmtool");

/// Returns counts under their names in tables.
nlohmann::ordered_json tableOf(const osgPMObjects::core::MeshCounts& counts);

/// Returns the counts of an import by name; zeros are left out.
nlohmann::ordered_json tableOf(const osgPMObjects::ImportReport& report);

/// Adds what was left out on the way from the file to the mesh: "import" and "notes", each unless it is
/// empty.
void addLosses(nlohmann::ordered_json& row, const ReadModel& model);

/// Prints what addLosses() has added to a row.
void printLosses(const nlohmann::ordered_json& row);

} // namespace pmtool
