// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include <osg/Image>

namespace measurement
{

/// How frames are laid out. Units: pixels.
struct ContactSheetSettings
{
    int columns = 4;
    int rows = 4;
    int widthPx = 1280; ///< of the whole sheet
    int gapPx = 4;
};

/// Which of `count` frames stand on a sheet: at equal intervals, the first and the last included; all, if they fit.
std::vector<std::size_t> contactSheetFrames(std::size_t count, const ContactSheetSettings& settings);

/// Small copies (each pixel the mean of those it covers) of the given picture files, in rows from the top left.
/// Errors: no files, one that cannot be read, or pictures of different sizes.
foundation::Result<osg::ref_ptr<osg::Image>> makeContactSheet(const std::vector<std::filesystem::path>& files,
                                                              const ContactSheetSettings& settings);

} // namespace measurement
