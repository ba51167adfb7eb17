// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace trainer
{

/// Reads a file in any format that OpenSceneGraph has a plugin for.
/// Threads: no other thread may use osg::notify meanwhile.
/// Errors: no such file, no plugin, a plugin that refuses it; the error contains the first message of
/// OpenSceneGraph, which is not printed. `remedy` is for the last two.
foundation::Result<osg::ref_ptr<osg::Node>> readModel(const std::filesystem::path& file,
                                                      const std::string& remedy);

} // namespace trainer
