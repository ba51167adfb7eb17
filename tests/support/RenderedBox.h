// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <osg/Image>
#include <osg/Matrixd>
#include <osg/Vec3d>

namespace rendered
{

/// A rectangle of a picture. Pixels from the lower left corner, the last ones included.
struct PixelBox
{
    int left = 0, low = 0, right = 0, high = 0;

    int count() const { return (right - left + 1) * (high - low + 1); }

    /// The mean of what `valueAt(x, y)` says of each pixel.
    template<class Value>
    double mean(const Value& valueAt) const
    {
        double sum = 0.0;
        for (int y = low; y <= high; ++y)
            for (int x = left; x <= right; ++x)
                sum += valueAt(x, y);
        return sum / count();
    }
};

/// The least box that has these places in it, as far as it lies in the picture. `toClip`: view, then
/// projection. Precondition: the places lie before the eye.
inline PixelBox boxAround(std::span<const osg::Vec3d> places, const osg::Matrixd& toClip,
                          const osg::Image& picture)
{
    double left = 1e9, low = 1e9, right = -1e9, high = -1e9;
    for (const osg::Vec3d& place : places)
    {
        const osg::Vec3d clip = place * toClip;
        const double x = 0.5 * (clip.x() + 1.0) * picture.s(), y = 0.5 * (clip.y() + 1.0) * picture.t();
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    const auto within = [](double at, int end)
    { return std::clamp(static_cast<int>(std::floor(at)), 0, end - 1); };
    return {within(left, picture.s()), within(low, picture.t()), within(right, picture.s()),
            within(high, picture.t())};
}

} // namespace rendered
