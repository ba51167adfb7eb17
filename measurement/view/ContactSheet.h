// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include <osg/Image>

namespace measurement
{

/// The layout of a contact sheet. Units: pixels.
struct ContactSheetSettings
{
    int columns = 4;
    int rows = 4;
    int widthPx = 1280; ///< of the whole sheet
    int gapPx = 4;
};

/// Chooses the frames of a sheet out of `count`: at equal intervals with the first and the last, or all when
/// they fit.
std::vector<std::size_t> contactSheetFrames(std::size_t count, const ContactSheetSettings& settings);

/// Makes a sheet of small copies of image files, in rows from the top left; each pixel is the mean of those
/// it covers.
/// Errors: no file, a file that cannot be read, images of different sizes.
foundation::Result<osg::ref_ptr<osg::Image>> makeContactSheet(const std::vector<std::filesystem::path>& files,
                                                              const ContactSheetSettings& settings);

} // namespace measurement
