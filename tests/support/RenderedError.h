// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <osg/Image>

namespace rendered
{

/// How far pictures are from others, over the pixels in which either shows something else than the background (its upper
/// left pixel): the root of the mean of the squared differences of all channels, in levels of 255. All are RGB of one size.
inline double silhouetteError(const std::vector<osg::ref_ptr<osg::Image>>& truth,
                              const std::vector<osg::ref_ptr<osg::Image>>& shown)
{
    double sum = 0.0;
    std::size_t channels = 0;
    EXPECT_EQ(truth.size(), shown.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
        const auto pixel = [](const osg::Image& image, int x, int y)
        { return reinterpret_cast<const unsigned char*>(image.data(x, y)); };
        const unsigned char* background = pixel(*truth[i], 0, 0);
        const auto isSomething = [&](const unsigned char* p)
        { return p[0] != background[0] || p[1] != background[1] || p[2] != background[2]; };
        for (int y = 0; y < truth[i]->t(); ++y)
            for (int x = 0; x < truth[i]->s(); ++x)
            {
                const unsigned char *a = pixel(*truth[i], x, y), *b = pixel(*shown[i], x, y);
                if (!isSomething(a) && !isSomething(b)) continue;
                channels += 3;
                for (int c = 0; c < 3; ++c)
                    sum += (a[c] - b[c]) * (a[c] - b[c]);
            }
    }
    EXPECT_GT(channels, 0u) << "there is nothing in the pictures";
    return channels > 0 ? std::sqrt(sum / static_cast<double>(channels)) : 0.0;
}

} // namespace rendered
