// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <osg/StateSet>

#include <osgPMObjects/core/progressive/PmFile.h>

namespace osgPMObjects
{

/// States whose images are kept beside them.
struct SeparatedStates
{
    std::vector<osg::ref_ptr<osg::StateSet>> states; ///< with a texel of the mean colour for each image
    std::vector<core::PmImage> images; ///< small ones first; the texels name them by their number
};

/// Takes the images out of states, which are copied for that. Films, and images that cannot be written as
/// files, stay.
/// `folder`: where relative file names of images may begin.
SeparatedStates separated(const std::vector<osg::ref_ptr<osg::StateSet>>& states,
                          const std::filesystem::path& folder);

/// Puts images in the place of their texels. Returns the number of texels that stay: their image is not
/// there, or is damaged.
std::size_t putBack(const std::vector<core::PmImage>& images,
                    const std::vector<osg::ref_ptr<osg::StateSet>>& states);

} // namespace osgPMObjects
