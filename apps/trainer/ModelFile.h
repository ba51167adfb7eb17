// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace trainer
{

/// Reads a file in any format that OpenSceneGraph has a plugin for.
/// Threads: none besides may speak through osg::notify meanwhile.
/// Errors: no such file, no plugin, a plugin that refuses it; what OpenSceneGraph says of it stands in the error, and
/// not on the terminal. `remedy` is for the last two.
foundation::Result<osg::ref_ptr<osg::Node>> readModel(const std::filesystem::path& file,
                                                      const std::string& remedy);

} // namespace trainer
