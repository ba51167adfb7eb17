// SPDX-License-Identifier: Apache-2.0
#include "Picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <osgOffscreen/PngFile>

namespace framebench
{

namespace
{

/// Returns the reciprocal of the distance at each pixel; 0: sky.
std::vector<double> nearnessOf(const osg::Image& distance)
{
    std::vector<double> nearness;
    for (int y = 0; y < distance.t(); ++y)
        for (int x = 0; x < distance.s(); ++x)
        {
            const unsigned char* p = distance.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            const double v = (p[0] + p[1] / 255.0) / 255.0;
            nearness.push_back(p[2] == 0 ? 0.0 : std::exp2(-(22.0 * v - 2.0)));
        }
    return nearness;
}

bool bends(double before, double at, double after)
{
    const double most = std::max({before, at, after});
    return most > 0.0 &&
           (std::min({before, at, after}) == 0.0 || std::abs(before - 2.0 * at + after) > 0.05 * most);
}

} // namespace

Picture boxFiltered(const osg::Image& image, int n)
{
    Picture picture{image.s() / n, image.t() / n, {}};
    picture.values.reserve(static_cast<std::size_t>(picture.widthPx) * picture.heightPx * 3);
    for (int y = 0; y < picture.heightPx; ++y)
        for (int x = 0; x < picture.widthPx; ++x)
        {
            int sum[3] = {};
            for (int v = 0; v < n; ++v)
            {
                const unsigned char* p =
                    image.data(static_cast<unsigned>(x * n), static_cast<unsigned>(y * n + v));
                for (int i = 0; i < 3 * n; ++i)
                    sum[i % 3] += p[i];
            }
            for (const int s : sum)
                picture.values.push_back(static_cast<std::int16_t>((2 * s + n * n) / (2 * n * n)));
        }
    return picture;
}

Picture difference(const Picture& a, const Picture& b)
{
    Picture result{a.widthPx, a.heightPx, {}};
    result.values.resize(a.values.size());
    std::transform(a.values.begin(), a.values.end(), b.values.begin(), result.values.begin(),
                   [](int x, int y) { return static_cast<std::int16_t>(x - y); });
    return result;
}

foundation::Outcome writePicture(const Picture& picture, int gain, const std::filesystem::path& file)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(picture.widthPx, picture.heightPx, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    std::transform(picture.values.begin(), picture.values.end(), image->data(),
                   [gain](int v) { return static_cast<unsigned char>(std::min(std::abs(v) * gain, 255)); });
    return osgOffscreen::writePng(*image, file);
}

std::vector<bool> silhouettes(const osg::Image& distance)
{
    const std::vector<double> nearness = nearnessOf(distance);
    const int width = distance.s(), height = distance.t();
    const auto at = [&](int x, int y) { return nearness[static_cast<std::size_t>(y) * width + x]; };
    std::vector<bool> edges(nearness.size());
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x)
            edges[static_cast<std::size_t>(y) * width + x] =
                bends(at(x - 1, y), at(x, y), at(x + 1, y)) || bends(at(x, y - 1), at(x, y), at(x, y + 1));
    return edges;
}

std::vector<bool> widened(const std::vector<bool>& a, const std::vector<bool>& b, int widthPx)
{
    std::vector<bool> wide(a.size());
    const int height = static_cast<int>(a.size()) / widthPx;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < widthPx; ++x)
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, widthPx - 1); ++u)
                {
                    const std::size_t from = static_cast<std::size_t>(v) * widthPx + u;
                    if (a[from] || b[from]) wide[static_cast<std::size_t>(y) * widthPx + x] = true;
                }
    return wide;
}

} // namespace framebench
