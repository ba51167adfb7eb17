// SPDX-License-Identifier: Apache-2.0
#include "pmtool/polygons/WarpTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pmtool
{

namespace
{

using foundation::Outcome;
using osgPMObjects::core::preWarpedTexCoord;

/// How far apart the sources of a texel may be that two faces show, in texels.
constexpr double kMostApart = 0.5;
/// The most texels of a face: it repeats the texture without end otherwise.
constexpr double kMostTexels = 1u << 28;

std::int64_t within(std::int64_t texel, std::uint32_t count)
{
    const auto n = static_cast<std::int64_t>(count);
    return (texel % n + n) % n;
}

/// The texels of a texture, each with the place from which it takes its colour.
class TexelSources
{
public:
    explicit TexelSources(const Texels& texture)
        : _texture(texture),
          _size(texture.width, texture.height),
          _sources(texture.colours.size(), glm::dvec2(std::numeric_limits<double>::quiet_NaN())),
          _owners(texture.colours.size(), 0)
    {
    }

    Outcome add(std::span<const TexturedFace> faces)
    {
        for (std::size_t f = 0; f < faces.size(); ++f)
        {
            const std::size_t triangles = faces[f].isQuad ? 2 : 1;
            for (std::size_t t = 0; t < triangles; ++t)
                if (auto done = addTriangle(faces, f, {0, 1 + t, 2 + t}); !done) return done;
        }
        return foundation::success();
    }

    Texels warped() const
    {
        Texels result = _texture;
        for (std::size_t i = 0; i < _sources.size(); ++i)
            if (!std::isnan(_sources[i].x)) result.colours[i] = colourAt(_sources[i]);
        return result;
    }

private:
    /// Claims the texels with their centre in one triangle of a face. In texels, centres are whole numbers.
    Outcome addTriangle(std::span<const TexturedFace> faces, std::size_t f,
                        const std::array<std::size_t, 3>& corners)
    {
        constexpr double kSlack = 1e-9; // rounding may leave out a centre between two triangles
        std::array<glm::dvec2, 3> at;
        for (std::size_t i = 0; i < 3; ++i)
            at[i] = faces[f].quad.texCoords[corners[i]] * _size - 0.5;
        const glm::dvec2 low = glm::ceil(glm::min(at[0], glm::min(at[1], at[2])) - kSlack),
                         high = glm::floor(glm::max(at[0], glm::max(at[1], at[2])) + kSlack);
        const bool areNumbers =
            std::all_of(at.begin(), at.end(),
                        [](const glm::dvec2& t) { return std::isfinite(t.x) && std::isfinite(t.y); });
        const double texels = std::max(high.x - low.x + 1.0, 0.0) * std::max(high.y - low.y + 1.0, 0.0);
        if (!areNumbers || texels > kMostTexels)
            return foundation::Error{faces[f].location, "shows too many texels, or none that can be counted",
                                     "give it texture coordinates near 0 … 1"};
        const glm::dvec2 e = at[1] - at[0], g = at[2] - at[0];
        const double area = e.x * g.y - e.y * g.x;
        if (area == 0.0) return foundation::success();
        for (double y = low.y; y <= high.y; ++y)
            for (double x = low.x; x <= high.x; ++x)
            {
                const glm::dvec2 h = glm::dvec2(x, y) - at[0];
                const double second = (h.x * g.y - h.y * g.x) / area, third = (e.x * h.y - e.y * h.x) / area;
                if (second < -kSlack || third < -kSlack || second + third > 1.0 + kSlack) continue;
                std::array<double, 4> weights{};
                weights[0] = 1.0 - second - third;
                weights[corners[1]] = second;
                weights[corners[2]] = third;
                if (auto done = claim(faces, f, {x, y}, weights); !done) return done;
            }
        return foundation::success();
    }

    Outcome claim(std::span<const TexturedFace> faces, std::size_t f, const glm::dvec2& texel,
                  const std::array<double, 4>& weights)
    {
        glm::dvec2 source = texel;
        if (faces[f].isQuad)
            if (const auto place = preWarpedTexCoord(faces[f].quad, weights)) source = *place * _size - 0.5;
        // The texture repeats: the source moves with the texel into 0 … 1.
        const glm::i64vec2 whole(texel),
            inside(within(whole.x, _texture.width), within(whole.y, _texture.height));
        source += glm::dvec2(inside - whole);
        const std::size_t i =
            static_cast<std::size_t>(inside.y) * _texture.width + static_cast<std::size_t>(inside.x);
        if (!std::isnan(_sources[i].x) && glm::distance(_sources[i], source) > kMostApart)
            return foundation::Error{
                faces[f].location, "shows texels that " + faces[_owners[i]].location + " shows otherwise",
                "give each quad a part of the texture for itself, or use grids or projective coordinates"};
        _sources[i] = source;
        _owners[i] = f;
        return foundation::success();
    }

    /// A place between a border of the texture and the nearest centres has the border's colour: what lies
    /// behind it is of the other side.
    glm::vec4 colourAt(glm::dvec2 place) const
    {
        for (int i = 0; i < 2; ++i)
            if (place[i] >= -0.5 && place[i] <= _size[i] - 0.5)
                place[i] = std::clamp(place[i], 0.0, _size[i] - 1.0);
        const glm::dvec2 low = glm::floor(place);
        const glm::vec2 part(place - low);
        const auto texel = [&](int right, int up)
        {
            const auto x = static_cast<std::size_t>(within(std::int64_t(low.x) + right, _texture.width)),
                       y = static_cast<std::size_t>(within(std::int64_t(low.y) + up, _texture.height));
            return _texture.colours[y * _texture.width + x];
        };
        return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x),
                        glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
    }

    const Texels& _texture;
    const glm::dvec2 _size;
    std::vector<glm::dvec2> _sources; ///< by texel, in texels; not a number: none
    std::vector<std::size_t> _owners; ///< by texel: the face that claimed it
};

} // namespace

foundation::Result<Texels> warpTexture(const Texels& texture, std::span<const TexturedFace> faces)
{
    TexelSources sources(texture);
    if (const auto done = sources.add(faces); !done) return done.error();
    return sources.warped();
}

} // namespace pmtool
