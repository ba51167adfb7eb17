// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/bake/BakeMaps.h>

#include "../mesh/UnitVector.h"
#include "FillTexels.h"
#include "SurfaceMatch.h"
#include "TexelOwners.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kLeastTexelsAThread = 512;
constexpr double kLeastNormal = 0.01; ///< below, corners look so different that their mean says nothing

glm::dvec3 geometricNormal(const Mesh& mesh, const Face& face)
{
    return glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0));
}

/// Returns the mean of the corners' normals, not normalised.
glm::dvec3 shadingNormal(const Mesh& mesh, const Face& face, const glm::dvec3& weights)
{
    glm::dvec3 sum(0.0);
    if (!mesh.normals.empty() && mesh.materials[face.material].has(Material::normal))
        for (int corner = 0; corner < 3; ++corner)
            sum += weights[corner] *
                   unitOr0(glm::dvec3(mesh.normals[face.wedges[static_cast<std::size_t>(corner)]]));
    return glm::length(sum) > kLeastNormal ? sum : unitOr0(geometricNormal(mesh, face));
}

std::uint8_t byteOf(double value)
{
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

/// Samples texels one by one.
class TexelBaker
{
public:
    TexelBaker(const Mesh& full, const Mesh& simplified, const Atlas& atlas, const ColourAt& colourAt,
               const BakeSettings& settings)
        : _full(full),
          _simplified(simplified),
          _atlas(atlas),
          _colourAt(colourAt),
          _samplesPerSide(std::clamp(settings.samplesPerSide, 1, 8)),
          _match(full, simplified, settings.reach)
    {
    }

    double reach() const { return _match.reach(); }

    /// Fills a texel of `maps` that belongs to a face. Returns whether all of its samples have a match.
    bool bake(std::size_t texel, std::uint32_t face, BakedMaps& maps) const
    {
        const auto size = static_cast<std::size_t>(_atlas.sizePx);
        const glm::dvec2 corner(static_cast<double>(texel % size), static_cast<double>(texel / size));
        const FlatTriangle flat = inAtlas(_simplified, _atlas, face);
        Sum sum;
        for (int y = 0; y < _samplesPerSide; ++y)
            for (int x = 0; x < _samplesPerSide; ++x)
                add(sum, face,
                    weightsAt(flat,
                              corner + (glm::dvec2(x, y) + 0.5) / static_cast<double>(_samplesPerSide)));
        const double count = _samplesPerSide * _samplesPerSide;
        for (int c = 0; c < 4; ++c)
            maps.colours[texel][static_cast<std::size_t>(c)] = byteOf(sum.colour[c] / count);
        for (int c = 0; c < 3; ++c)
            maps.normals[texel][static_cast<std::size_t>(c)] = byteOf(0.5 + 0.5 * sum.normal[c] / count);
        return sum.agrees;
    }

private:
    struct Sum
    {
        glm::dvec4 colour{0.0};
        glm::dvec3 normal{0.0};
        bool agrees = true;
    };

    void add(Sum& sum, std::uint32_t f, const glm::dvec3& weights) const
    {
        const Face& face = _simplified.faces[f];
        const glm::dvec3 point = weights.x * _simplified.at(face, 0) + weights.y * _simplified.at(face, 1) +
                                 weights.z * _simplified.at(face, 2);
        const glm::dvec3 shading = shadingNormal(_simplified, face, weights);
        // A face visible from both sides may have normals that point away from its front.
        const glm::dvec3 outwards =
            glm::dot(shading, geometricNormal(_simplified, face)) < 0.0 ? -shading : shading;
        const MatchedPoint match = _match.find(point, unitOr0(outwards), face);
        sum.colour += glm::dvec4(_colourAt(match.face, match.weights, f));
        sum.normal += match.agrees ? shadingNormal(_full, _full.faces[match.face], match.weights) : shading;
        sum.agrees = sum.agrees && match.agrees;
    }

    const Mesh& _full;
    const Mesh& _simplified;
    const Atlas& _atlas;
    const ColourAt& _colourAt;
    int _samplesPerSide;
    SurfaceMatch _match;
};

} // namespace

BakedMaps bakeMaps(const Mesh& full, const Mesh& simplified, const Atlas& atlas, const ColourAt& colourAt,
                   const BakeSettings& settings)
{
    const TexelBaker baker(full, simplified, atlas, colourAt, settings);
    const TexelOwners owners = texelOwners(simplified, atlas);
    std::vector<std::uint32_t> owned;
    std::vector<std::uint8_t> isShown(owners.faces.size(), 0);
    for (std::size_t i = 0; i < owners.faces.size(); ++i)
        if (owners.faces[i] != TexelOwners::kNone)
        {
            owned.push_back(static_cast<std::uint32_t>(i));
            isShown[i] = 1;
        }
    BakedMaps maps;
    maps.sizePx = atlas.sizePx;
    maps.colours.resize(owners.faces.size());
    maps.normals.resize(owners.faces.size());
    std::vector<std::size_t> unmatched(foundation::processors(), 0);
    parallelShares(owned.size(), kLeastTexelsAThread,
                   [&](std::size_t first, std::size_t last, std::size_t share)
                   {
                       std::size_t count = 0;
                       for (std::size_t i = first; i < last; ++i)
                           if (!baker.bake(owned[i], owners.faces[owned[i]], maps)) ++count;
                       unmatched[share] = count;
                   });
    for (const std::size_t count : unmatched)
        maps.unmatchedTexels += count;
    maps.coveredTexels = owners.covered;
    maps.lookedUpTexels = owned.size();
    maps.reach = baker.reach();
    const auto size = static_cast<std::size_t>(atlas.sizePx);
    fillTexels(maps.colours, isShown, size);
    fillTexels(maps.normals, std::move(isShown), size);
    return maps;
}

} // namespace osgPMObjects::core
