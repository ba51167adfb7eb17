// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/StateSet>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects
{

/// The content of a `.pm` file.
struct PmContents
{
    core::ProgressiveMesh mesh;
    std::string attachment;
};

/// Reads a whole `.pm` file. Errors: as core::PmReader.
foundation::Result<PmContents> readPmContents(std::istream& stream, const std::string& place);

/// Appends empty states until there are as many as the materials of the mesh name.
/// Errors: they name more than the mesh can have, so the file is damaged.
foundation::Outcome fitStates(std::vector<osg::ref_ptr<osg::StateSet>>& states,
                              const core::ProgressiveMesh& mesh, const std::string& place);

} // namespace osgPMObjects
