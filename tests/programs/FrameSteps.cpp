// SPDX-License-Identifier: Apache-2.0
#include "FrameSteps.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <osgOffscreen/PngFile>

#include "Playing.h"

namespace
{

Difference differenceOf(const osg::Image& a, const osg::Image& b)
{
    Difference difference;
    const int across = a.s() / kSquarePx, up = a.t() / kSquarePx;
    if (a.s() != b.s() || a.t() != b.t() || a.getPixelSizeInBits() != b.getPixelSizeInBits())
        return {{}, 255.0};
    const int channels = static_cast<int>(a.getPixelSizeInBits() / 8);
    difference.squares.resize(static_cast<std::size_t>(across * up));
    for (int y = 0; y < up * kSquarePx; ++y)
        for (int byte = 0; byte < across * kSquarePx * channels; ++byte)
            difference
                .squares[static_cast<std::size_t>(y / kSquarePx * across + byte / (kSquarePx * channels))] +=
                std::abs(static_cast<int>(a.data(0, y)[byte]) - static_cast<int>(b.data(0, y)[byte])) /
                static_cast<double>(kSquarePx * kSquarePx * channels);
    for (const double square : difference.squares)
        difference.mean += square / static_cast<double>(difference.squares.size());
    return difference;
}

} // namespace

Frames framesIn(const std::filesystem::path& folder)
{
    Frames images;
    for (const auto& [name, bytes] : bytesIn(folder))
        if (auto image = osgOffscreen::readPng(folder / name)) images.push_back(*image);
    return images;
}

std::vector<Difference> stepsOf(const Frames& images)
{
    std::vector<Difference> steps;
    for (std::size_t i = 1; i < images.size(); ++i)
        steps.push_back(differenceOf(*images[i - 1], *images[i]));
    return steps;
}

double meanOf(const std::vector<Difference>& steps)
{
    double sum = 0.0;
    for (const Difference& step : steps)
        sum += step.mean;
    return sum / static_cast<double>(steps.size());
}

Excess worstExcess(const std::vector<Difference>& steps, const std::vector<Difference>& fine)
{
    Excess worst;
    for (std::size_t i = 0; i < std::min(steps.size(), fine.size()); ++i)
    {
        worst.ofMean = std::max(worst.ofMean, steps[i].mean - fine[i].mean);
        for (std::size_t k = 0; k < std::min(steps[i].squares.size(), fine[i].squares.size()); ++k)
            if (const double excess = steps[i].squares[k] - fine[i].squares[k]; excess > worst.ofSquare)
            {
                worst.ofSquare = excess;
                worst.frame = i + 1;
                worst.square = k;
            }
    }
    return worst;
}

std::ostream& operator<<(std::ostream& stream, const Excess& excess)
{
    return stream << "worst excess " << excess.ofMean << ", of a square " << excess.ofSquare << " (frame "
                  << excess.frame << ", number " << excess.square << ')';
}

osg::ref_ptr<osg::Image> withSquare(const osg::Image& image, int left, int bottom, int sidePx)
{
    osg::ref_ptr<osg::Image> painted = new osg::Image(image, osg::CopyOp::DEEP_COPY_ALL);
    for (int y = bottom; y < bottom + sidePx; ++y)
        for (int x = left; x < left + sidePx; ++x)
            std::fill_n(painted->data(x, y), image.getPixelSizeInBits() / 8,
                        static_cast<unsigned char>(0x20));
    return painted;
}
