// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>

#include <osgOffscreen/ImageComparison>

namespace osgOffscreen
{

namespace
{

bool isSameShape(const osg::Image& a, const osg::Image& b)
{
    return a.s() == b.s() && a.t() == b.t() && a.r() == 1 && b.r() == 1 &&
           a.getPixelFormat() == b.getPixelFormat() && a.getDataType() == GL_UNSIGNED_BYTE &&
           b.getDataType() == GL_UNSIGNED_BYTE && a.data() && b.data();
}

int channelsOf(const osg::Image& image)
{
    return static_cast<int>(osg::Image::computeNumComponents(image.getPixelFormat()));
}

int largestStepAt(const osg::Image& a, const osg::Image& b, int x, int y)
{
    const unsigned char* pa = a.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
    const unsigned char* pb = b.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
    int largest = 0;
    for (int c = 0; c < channelsOf(a); ++c)
        largest = std::max(largest, std::abs(pa[c] - pb[c]));
    return largest;
}

} // namespace

std::string ImageDifference::message() const
{
    if (!sameShape) return "the pictures have different sizes or formats";
    if (identical()) return "identical";
    return std::to_string(differingPixels) + " pixels differ, by " + std::to_string(largestStep) +
           " levels at most, the first at x " + std::to_string(firstXPx) + ", y " +
           std::to_string(firstYFromTopPx) + " from the top";
}

ImageDifference compareImages(const osg::Image& a, const osg::Image& b)
{
    ImageDifference difference;
    difference.sameShape = isSameShape(a, b);
    if (!difference.sameShape) return difference;
    for (int row = 0; row < a.t(); ++row)
    {
        for (int x = 0; x < a.s(); ++x)
        {
            const int step = largestStepAt(a, b, x, a.t() - 1 - row);
            if (step == 0) continue;
            if (difference.differingPixels++ == 0)
            {
                difference.firstXPx = x;
                difference.firstYFromTopPx = row;
            }
            difference.largestStep = std::max(difference.largestStep, step);
        }
    }
    return difference;
}

osg::ref_ptr<osg::Image> differenceImage(const osg::Image& a, const osg::Image& b)
{
    const ImageDifference difference = compareImages(a, b);
    if (!difference.sameShape) return nullptr;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(a.s(), a.t(), 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    const int scale = std::max(difference.largestStep, 1);
    const int channels = channelsOf(a);
    for (int y = 0; y < a.t(); ++y)
    {
        for (int x = 0; x < a.s(); ++x)
        {
            const unsigned char* pa = a.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            const unsigned char* pb = b.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            unsigned char* out = image->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            for (int c = 0; c < 3; ++c)
            {
                const int channel = std::min(c, channels - 1);
                out[c] = static_cast<unsigned char>(std::abs(pa[channel] - pb[channel]) * 255 / scale);
            }
        }
    }
    return image;
}

} // namespace osgOffscreen
