// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <osgPMObjects/core/simplify/SimplificationError.h>

#include "compare/objects/SimplifyTool.h"

namespace pmtool
{

/// A model, with everything that is the same for every tool.
struct SimplifySubject
{
    std::string name;               ///< of its dumps
    osgPMObjects::core::Mesh mesh;  ///< see SimplifyTask
    osgPMObjects::core::Mesh shape; ///< see shapeOf()
    osgPMObjects::core::SimplificationMeter meter;
    std::vector<double> percents;     ///< of the faces, falling
    std::vector<std::size_t> targets; ///< most faces for each, at least one

    SimplifySubject(std::string subjectName, osgPMObjects::core::Mesh clean,
                    std::vector<double> targetPercents);
};

/// Measures a level and adds the figures to its row.
void addMeasures(nlohmann::ordered_json& row, const SimplifySubject& subject, const SimplifiedLevel& level,
                 std::size_t target);

/// Writes a mesh as FOLDER/STEM.obj (writePlain()), and one with texture coordinates as FOLDER/STEM.uv.obj
/// (writeTextured()), too; the files' names go into the row. Errors: a file cannot be written.
foundation::Outcome dump(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& folder,
                         const std::string& stem, nlohmann::ordered_json& row);

/// Returns the name of a row's dump: "forklift.subset.seams.5".
std::string dumpName(const SimplifySubject& subject, const nlohmann::ordered_json& row);

/// Print to the standard output.
void printHeading(const std::string& file, const SimplifySubject& subject);
void printRow(const nlohmann::ordered_json& row);

} // namespace pmtool
