// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace trainer
{

/// A model that OpenSceneGraph has read.
struct ModelFromFile
{
    osg::ref_ptr<osg::Node> node;
    /// One for each image that is missing; of roads, glTF and .pm what is wrong or left out besides.
    std::vector<std::string> notes;
};

/// Reads a file in any format that OpenSceneGraph has a plugin for.
/// Threads: no other thread may use osg::notify meanwhile.
/// Errors: no such file, no plugin, a plugin that refuses it; the error contains the first message of
/// OpenSceneGraph, which is not printed. `remedy` is for the last two.
foundation::Result<ModelFromFile> readModel(const std::filesystem::path& file, const std::string& remedy);

} // namespace trainer
