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

/// All that a `.pm` file has.
struct PmContents
{
    core::ProgressiveMesh mesh;
    std::string attachment;
};

/// Errors: as core::PmReader.
foundation::Result<PmContents> readPmContents(std::istream& stream, const std::string& place);

/// Gives a mesh as many states as its materials name, empty ones where there are none.
/// Errors: they name more than the mesh can have materials, so that the file is damaged.
foundation::Outcome fitStates(std::vector<osg::ref_ptr<osg::StateSet>>& states,
                              const core::ProgressiveMesh& mesh, const std::string& place);

} // namespace osgPMObjects
