// SPDX-License-Identifier: Apache-2.0
#include "DetailImages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "ImageBytes.h"
#include "TileableNoise.h"

namespace osgTerrainROAM
{

namespace
{

constexpr double kTexelM = kDetailPeriodM / kDetailSide;

/// The bodies of one surface. Units: metres.
struct Stamps
{
    int count;
    double lengthM, widthM; ///< the longest; the shortest are half of it
    double highM;           ///< of a body at its top
    double tilt;            ///< 0: a dome; 1: rises from one end to the other
    float toneSpread;       ///< of the brightness from body to body
};

/// Heights and brightness of a square that repeats.
class Surface
{
public:
    explicit Surface(std::uint32_t seed) : _state(seed) {}

    void addNoise(const TileableNoise::Octaves& octaves, double highM, float tone)
    {
        const TileableNoise noise(kDetailSide, octaves);
        for (int y = 0; y < kDetailSide; ++y)
            for (int x = 0; x < kDetailSide; ++x)
            {
                _heights[index(x, y)] += static_cast<float>(highM) * noise.at(x, y);
                _tones[index(x, y)] += tone * (noise.at(x, y) - 0.5f);
            }
    }

    /// Cuts cracks where noise passes its mean.
    void addCracks(const TileableNoise::Octaves& octaves, double deepM)
    {
        const TileableNoise noise(kDetailSide, octaves);
        for (int y = 0; y < kDetailSide; ++y)
            for (int x = 0; x < kDetailSide; ++x)
            {
                const float near = std::max(1.0f - std::abs(noise.at(x, y) - 0.5f) / 0.025f, 0.0f);
                _heights[index(x, y)] -= static_cast<float>(deepM) * near;
                _tones[index(x, y)] -= 0.35f * near;
            }
    }

    void add(const Stamps& stamps)
    {
        const std::vector<float> floor = _heights;
        for (int i = 0; i < stamps.count; ++i)
            stamp(stamps, floor);
    }

    osg::ref_ptr<osg::Image> image() const;

private:
    static std::size_t index(int x, int y)
    {
        return static_cast<std::size_t>(y & (kDetailSide - 1)) * kDetailSide + (x & (kDetailSide - 1));
    }

    /// A random number, 0 … 1: xorshift.
    double unit()
    {
        _state ^= _state << 13;
        _state ^= _state >> 17;
        _state ^= _state << 5;
        return (_state >> 8) * (1.0 / 16777216.0);
    }

    void stamp(const Stamps& stamps, const std::vector<float>& floor);

    std::uint32_t _state;
    std::vector<float> _heights = std::vector<float>(kDetailSide * kDetailSide, 0.0f);
    std::vector<float> _tones = std::vector<float>(kDetailSide * kDetailSide, 0.0f);
};

void Surface::stamp(const Stamps& stamps, const std::vector<float>& floor)
{
    const double size = 0.5 + 0.5 * unit(), halfM = 0.5 * stamps.lengthM * size,
                 wideM = 0.5 * stamps.widthM * size;
    const double turn = 2.0 * std::numbers::pi * unit(), c = std::cos(turn), s = std::sin(turn);
    const double atX = unit() * kDetailSide, atY = unit() * kDetailSide;
    const float tone = stamps.toneSpread * static_cast<float>(unit() - 0.5);
    const int reach = static_cast<int>(std::ceil(std::max(halfM, wideM) / kTexelM));
    const float base = floor[index(static_cast<int>(atX), static_cast<int>(atY))];
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
        {
            const double along = (c * x + s * y) * kTexelM / halfM,
                         across = (c * y - s * x) * kTexelM / wideM;
            const double away = along * along + across * across;
            if (away >= 1.0) continue;
            const double dome = std::sqrt(1.0 - away), slant = 0.5 + 0.5 * along;
            const auto high =
                static_cast<float>(stamps.highM * size * ((1.0 - stamps.tilt) * dome + stamps.tilt * slant));
            const std::size_t i = index(static_cast<int>(atX) + x, static_cast<int>(atY) + y);
            if (base + high <= _heights[i]) continue;
            _heights[i] = base + high;
            _tones[i] = tone;
        }
}

unsigned char packed(float value)
{
    return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

float meanOf(const std::vector<float>& values)
{
    double sum = 0.0;
    for (const float value : values)
        sum += value;
    return static_cast<float>(sum / static_cast<double>(values.size()));
}

osg::ref_ptr<osg::Image> Surface::image() const
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kDetailSide, kDetailSide, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_RGBA8);
    const float meanHeight = meanOf(_heights), meanTone = meanOf(_tones);
    // Between the bodies less of the sky is seen.
    constexpr float kHollow = 0.35f;
    for (int y = 0; y < kDetailSide; ++y)
        for (int x = 0; x < kDetailSide; ++x)
        {
            unsigned char* out = image->data(x, y);
            const auto slope = [&](int dx, int dy)
            {
                const float rise = _heights[index(x + dx, y + dy)] - _heights[index(x - dx, y - dy)];
                return 0.5f + rise / static_cast<float>(2.0 * kTexelM * 2.0 * kDetailSlope);
            };
            const float high = (_heights[index(x, y)] - meanHeight) / static_cast<float>(kDetailHeightM);
            out[0] = packed(slope(1, 0));
            out[1] = packed(slope(0, 1));
            out[2] = packed(0.5f + high);
            out[3] = packed(0.5f + 0.5f * (_tones[index(x, y)] - meanTone) + 0.5f * kHollow * high);
        }
    return image;
}

} // namespace

osg::ref_ptr<osg::Image> detailImage(Detail detail)
{
    Surface surface(0x9E3779B9u + 7919u * static_cast<std::uint32_t>(detail));
    switch (detail)
    {
    case Detail::grass:
        surface.addNoise({6, 3, 0.5, 41}, 0.015, 0.3f);
        surface.add({2600, 0.11, 0.011, 0.032, 0.85, 0.7f});
        break;
    case Detail::stones:
        surface.addNoise({10, 4, 0.6, 43}, 0.008, 0.3f);
        surface.add({1500, 0.045, 0.034, 0.016, 0.1, 0.9f});
        surface.add({1800, 0.020, 0.016, 0.010, 0.1, 0.9f});
        break;
    case Detail::earth:
        surface.addNoise({5, 6, 0.62, 47}, 0.035, 0.5f);
        surface.add({260, 0.040, 0.032, 0.012, 0.0, 0.3f});
        surface.add({60, 0.022, 0.018, 0.008, 0.1, 1.0f});
        break;
    case Detail::rock:
        surface.addNoise({3, 7, 0.58, 53}, 0.055, 0.7f);
        surface.addCracks({3, 4, 0.55, 59}, 0.02);
        surface.addCracks({7, 3, 0.55, 61}, 0.008);
        break;
    case Detail::snow:
        surface.addNoise({4, 5, 0.5, 67}, 0.015, 0.1f);
        break;
    case Detail::litter:
        surface.addNoise({5, 4, 0.55, 71}, 0.02, 0.4f);
        surface.add({900, 0.075, 0.040, 0.007, 0.6, 1.0f});
        surface.add({70, 0.20, 0.008, 0.012, 0.1, 0.8f});
        break;
    }
    return surface.image();
}

osg::ref_ptr<osg::Texture2DArray> detailTexture(const foundation::KeptFrom& kept)
{
    osg::ref_ptr<osg::Texture2DArray> texture = new osg::Texture2DArray;
    texture->setTextureSize(kDetailSide, kDetailSide, kDetails);
    texture->setInternalFormat(GL_RGBA8);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    for (int i = 0; i < kDetails; ++i)
        texture->setImage(static_cast<unsigned>(i),
                          keptImage(kept, "detail",
                                    foundation::ContentMark().addWord(static_cast<unsigned>(i)),
                                    [&] { return detailImage(static_cast<Detail>(i)); }));
    return texture;
}

} // namespace osgTerrainROAM
