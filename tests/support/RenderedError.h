// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <osg/Image>

namespace rendered
{

/// Calls `visit(a's pixel, b's)`, three bytes each, where either shows something else than the background,
/// which is a's first pixel. Both are RGB of one size.
template<class Visit>
void visitCovered(const osg::Image& a, const osg::Image& b, const Visit& visit)
{
    const unsigned char* const background = a.data(0, 0);
    const auto isSomething = [&](const unsigned char* p)
    { return p[0] != background[0] || p[1] != background[1] || p[2] != background[2]; };
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const unsigned char *pa = a.data(x, y), *pb = b.data(x, y);
            if (isSomething(pa) || isSomething(pb)) visit(pa, pb);
        }
}

/// How far pictures are from others, over the pixels in which either shows something else than the
/// background: the root of the mean of the squared differences of all channels, in levels of 255.
inline double silhouetteError(const std::vector<osg::ref_ptr<osg::Image>>& truth,
                              const std::vector<osg::ref_ptr<osg::Image>>& shown)
{
    double sum = 0.0;
    std::size_t channels = 0;
    EXPECT_EQ(truth.size(), shown.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
        visitCovered(*truth[i], *shown[i],
                     [&](const unsigned char* a, const unsigned char* b)
                     {
                         channels += 3;
                         for (int c = 0; c < 3; ++c)
                             sum += (a[c] - b[c]) * (a[c] - b[c]);
                     });
    EXPECT_GT(channels, 0u) << "there is nothing in the pictures";
    return channels > 0 ? std::sqrt(sum / static_cast<double>(channels)) : 0.0;
}

/// The same of luminance (0…1) in one view; 0 where nothing is covered.
inline double imageError(const osg::Image& a, const osg::Image& b)
{
    const auto luminance = [](const unsigned char* p)
    { return (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / 255.0; };
    double sum = 0.0;
    std::size_t covered = 0;
    visitCovered(a, b,
                 [&](const unsigned char* pa, const unsigned char* pb)
                 {
                     const double gap = luminance(pa) - luminance(pb);
                     sum += gap * gap;
                     ++covered;
                 });
    return covered == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(covered));
}

/// Mean over the views, each of which counts as much.
inline double imageError(const std::vector<osg::ref_ptr<osg::Image>>& a,
                         const std::vector<osg::ref_ptr<osg::Image>>& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += imageError(*a[i], *b[i]);
    return a.empty() ? 0.0 : sum / static_cast<double>(a.size());
}

} // namespace rendered
