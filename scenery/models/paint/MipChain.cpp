// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/MipChain.h"

#include <algorithm>
#include <cmath>

namespace scenery::models
{

namespace
{

Picture halved(const Picture& from, bool byAlpha)
{
    Picture to{std::max(from.widthPx / 2, 1), std::max(from.heightPx / 2, 1), {}};
    to.rgba.resize(4 * static_cast<std::size_t>(to.widthPx) * to.heightPx);
    for (int y = 0; y < to.heightPx; ++y)
        for (int x = 0; x < to.widthPx; ++x)
        {
            double sum[4] = {};
            double weights = 0.0;
            for (int k = 0; k < 4; ++k)
            {
                const std::uint8_t* p = from.at(std::min(2 * x + k % 2, from.widthPx - 1),
                                                std::min(2 * y + k / 2, from.heightPx - 1));
                const double weight = byAlpha ? p[3] + 1.0 : 1.0;
                for (int c = 0; c < 3; ++c)
                    sum[c] += weight * p[c];
                sum[3] += p[3];
                weights += weight;
            }
            for (int c = 0; c < 3; ++c)
                to.at(x, y)[c] = static_cast<std::uint8_t>(sum[c] / weights + 0.5);
            to.at(x, y)[3] = static_cast<std::uint8_t>(sum[3] / 4.0 + 0.5);
        }
    return to;
}

Picture withAlphaScaled(Picture picture, double scale)
{
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
        picture.rgba[i] = static_cast<std::uint8_t>(std::min(picture.rgba[i] * scale + 0.5, 255.0));
    return picture;
}

Picture withCoverage(const Picture& picture, double coverage)
{
    double low = 0.25;
    double high = 8.0;
    for (int i = 0; i < 16; ++i)
    {
        const double middle = 0.5 * (low + high);
        (coverageOf(withAlphaScaled(picture, middle)) < coverage ? low : high) = middle;
    }
    return withAlphaScaled(picture, high);
}

} // namespace

double coverageOf(const Picture& picture)
{
    std::size_t covered = 0;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
        covered += picture.rgba[i] > kAlphaThreshold ? 1 : 0;
    return 4.0 * static_cast<double>(covered) / static_cast<double>(picture.rgba.size());
}

std::vector<Picture> mipChain(const Picture& picture, bool keepCoverage)
{
    const double coverage = coverageOf(picture);
    std::vector<Picture> chain{picture};
    Picture plain = picture;
    while (plain.widthPx > 1 || plain.heightPx > 1)
    {
        plain = halved(plain, keepCoverage);
        chain.push_back(keepCoverage ? withCoverage(plain, coverage) : plain);
    }
    return chain;
}

} // namespace scenery::models
