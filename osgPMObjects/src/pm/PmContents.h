// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <string>
#include <vector>

#include <osg/StateSet>

#include <viewlod/Result.h>

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
viewlod::Result<PmContents> readPmContents(std::istream& stream, const std::string& place);

/// Gives a mesh as many states as its materials name, empty ones where there are none.
/// Errors: they name more than the mesh can have materials, so that the file is damaged.
viewlod::Outcome fitStates(std::vector<osg::ref_ptr<osg::StateSet>>& states,
                           const core::ProgressiveMesh& mesh, const std::string& place);

} // namespace osgPMObjects
