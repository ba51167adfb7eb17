// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <osg/Image>
#include <osgDB/WriteFile>

namespace rendered
{

/// Where the variable OSGTRAINER_KEEP_PICTURES names a folder, a picture is left there to be looked at.
inline void keep(const osg::Image& picture, const std::string& name)
{
    if (const char* const folder = std::getenv("OSGTRAINER_KEEP_PICTURES"))
        osgDB::writeImageFile(picture, (std::filesystem::path(folder) / (name + ".png")).string());
}

} // namespace rendered
