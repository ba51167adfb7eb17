// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/ProgressiveShape>
#include <osgTraversal/SceneFile>

namespace osgPMObjects
{

/// Writes a shape as an object of the scene file, which has it once, whoever shares it.
void writeShape(osgDB::OutputStream& out, const ProgressiveShape& shape);

/// Reads a shape. Errors: there is none, or it has no levels; then the stream has an exception that names
/// `owner`.
osg::ref_ptr<ProgressiveShape> readShape(osgDB::InputStream& in, const char* owner);

} // namespace osgPMObjects
