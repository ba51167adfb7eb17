// SPDX-License-Identifier: Apache-2.0
#include "measurement/view/ContactSheet.h"

#include <algorithm>
#include <cstring>

#include <osgOffscreen/PngFile>

namespace measurement
{

using foundation::Error;
using foundation::Result;

namespace
{

struct Cell
{
    int leftPx, bottomPx, widthPx, heightPx;
};

/// The mean of the pixels of `from` that one pixel of a smaller copy covers.
void copyReduced(const osg::Image& from, osg::Image& sheet, const Cell& cell)
{
    for (int y = 0; y < cell.heightPx; ++y)
    {
        const int y0 = y * from.t() / cell.heightPx;
        const int y1 = std::max((y + 1) * from.t() / cell.heightPx, y0 + 1);
        for (int x = 0; x < cell.widthPx; ++x)
        {
            const int x0 = x * from.s() / cell.widthPx;
            const int x1 = std::max((x + 1) * from.s() / cell.widthPx, x0 + 1);
            int sums[3] = {};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (int c = 0; c < 3; ++c)
                        sums[c] += from.data(static_cast<unsigned>(u), static_cast<unsigned>(v))[c];
            unsigned char* out =
                sheet.data(static_cast<unsigned>(cell.leftPx + x), static_cast<unsigned>(cell.bottomPx + y));
            const int covered = (x1 - x0) * (y1 - y0);
            for (int c = 0; c < 3; ++c)
                out[c] = static_cast<unsigned char>((sums[c] + covered / 2) / covered);
        }
    }
}

} // namespace

std::vector<std::size_t> contactSheetFrames(std::size_t count, const ContactSheetSettings& settings)
{
    const std::size_t places =
        std::min(count, static_cast<std::size_t>(settings.columns) * static_cast<std::size_t>(settings.rows));
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < places; ++i)
        frames.push_back(places == 1 ? 0 : i * (count - 1) / (places - 1));
    return frames;
}

Result<osg::ref_ptr<osg::Image>> makeContactSheet(const std::vector<std::filesystem::path>& files,
                                                  const ContactSheetSettings& settings)
{
    if (files.empty()) return Error{"contact sheet", "there are no frames", "capture at least one frame"};
    const int columns = std::min(settings.columns, static_cast<int>(files.size()));
    const int rows = (static_cast<int>(files.size()) + columns - 1) / columns;
    osg::ref_ptr<osg::Image> sheet;
    Cell cell{0, 0, (settings.widthPx - (columns + 1) * settings.gapPx) / columns, 0};
    int width = 0;
    int height = 0;
    for (std::size_t i = 0; i < files.size(); ++i)
    {
        const Result<osg::ref_ptr<osg::Image>> read = osgOffscreen::readPng(files[i]);
        if (!read) return read.error();
        const osg::Image& picture = **read;
        if (i == 0)
        {
            width = picture.s();
            height = picture.t();
            cell.heightPx = std::max(cell.widthPx * height / width, 1);
            sheet = new osg::Image;
            sheet->allocateImage(settings.widthPx, rows * (cell.heightPx + settings.gapPx) + settings.gapPx,
                                 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
            std::memset(sheet->data(), 0xFF, sheet->getTotalSizeInBytes());
        }
        if (picture.s() != width || picture.t() != height ||
            osg::Image::computeNumComponents(picture.getPixelFormat()) < 3)
            return Error{files[i].string(), "is not a colour picture of the first one's size",
                         "capture the frames anew"};
        const int row = static_cast<int>(i) / columns;
        const int column = static_cast<int>(i) % columns;
        cell.leftPx = settings.gapPx + column * (cell.widthPx + settings.gapPx);
        cell.bottomPx = sheet->t() - (row + 1) * (cell.heightPx + settings.gapPx);
        copyReduced(picture, *sheet, cell);
    }
    return sheet;
}

} // namespace measurement
