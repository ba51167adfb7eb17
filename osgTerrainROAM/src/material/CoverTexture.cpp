// SPDX-License-Identifier: Apache-2.0
#include "CoverTexture.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace osgTerrainROAM
{

namespace
{

struct CoverLevel
{
    int width, height;
    std::vector<unsigned char> kinds;

    unsigned char at(int x, int y) const
    {
        return kinds[static_cast<std::size_t>(std::min(y, height - 1)) * width + std::min(x, width - 1)];
    }
};

unsigned char mostOf(const std::array<unsigned char, 4>& four)
{
    if (four[0] == four[1] && four[0] == four[2] && four[0] == four[3]) return four[0]; // nearly all
    unsigned char most = four[0];
    std::ptrdiff_t votes = 0;
    for (const unsigned char kind : four)
        if (const auto count = std::count(four.begin(), four.end(), kind); count > votes)
        {
            most = kind;
            votes = count;
        }
    return most;
}

CoverLevel halved(const CoverLevel& fine)
{
    CoverLevel coarse{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
    coarse.kinds.reserve(static_cast<std::size_t>(coarse.width) * coarse.height);
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            coarse.kinds.push_back(mostOf({fine.at(2 * x, 2 * y), fine.at(2 * x + 1, 2 * y),
                                           fine.at(2 * x, 2 * y + 1), fine.at(2 * x + 1, 2 * y + 1)}));
    return coarse;
}

} // namespace

osg::ref_ptr<osg::Image> coverImage(const core::CoverMap& map)
{
    std::vector<CoverLevel> levels{{map.width, map.height, {}}};
    levels[0].kinds.reserve(map.kinds.size());
    for (const core::GroundKind kind : map.kinds)
        levels[0].kinds.push_back(static_cast<unsigned char>(kind));
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(halved(levels.back()));

    osg::Image::MipmapDataType offsets;
    std::size_t bytes = 0;
    for (const CoverLevel& level : levels)
    {
        if (bytes > 0) offsets.push_back(static_cast<unsigned>(bytes));
        bytes += level.kinds.size();
    }
    auto* data = new unsigned char[bytes];
    std::size_t at = 0;
    for (const CoverLevel& level : levels)
    {
        std::memcpy(data + at, level.kinds.data(), level.kinds.size());
        at += level.kinds.size();
    }
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(map.width, map.height, 1, GL_R8, GL_RED, GL_UNSIGNED_BYTE, data,
                    osg::Image::USE_NEW_DELETE, 1);
    image->setMipmapLevels(offsets);
    return image;
}

} // namespace osgTerrainROAM
