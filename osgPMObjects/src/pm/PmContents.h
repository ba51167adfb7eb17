// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/StateSet>

#include <osgPMObjects/core/progressive/PmFile.h>

namespace osgPMObjects
{

/// The content of a `.pm` file.
struct PmContents
{
    core::ProgressiveMesh mesh;
    std::string attachment;
    std::vector<core::PmImage> images;
    std::uint32_t missingSteps = 0; ///< behind the end of a file that is cut off
    bool isCutOff = false;
};

/// Whether a file that ends behind its coarsest level, but too early, counts as a coarser one.
enum class CutFiles
{
    refused,
    accepted,
};

/// Reads a `.pm` file. Errors: as core::PmReader.
foundation::Result<PmContents> readPmContents(std::istream& stream, const std::string& place,
                                              CutFiles cutFiles);

/// Appends empty states until there are as many as the materials of the mesh name.
/// Errors: they name more than the mesh can have, so the file is damaged.
foundation::Outcome fitStates(std::vector<osg::ref_ptr<osg::StateSet>>& states,
                              const core::ProgressiveMesh& mesh, const std::string& place);

} // namespace osgPMObjects
