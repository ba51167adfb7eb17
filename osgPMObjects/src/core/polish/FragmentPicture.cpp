// SPDX-License-Identifier: Apache-2.0
#include "FragmentPicture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <osgPMObjects/core/polish/PolishByImages.h>

#include "../mesh/Squared.h"
#include "TriangleRaster.h"

namespace osgPMObjects::core
{

namespace
{

constexpr float kFarthest = -std::numeric_limits<float>::infinity();
constexpr float kAmbient = 0.1f; ///< share of the light on a surface that faces the lamp

/// Returns the luminance of a corner lit by a lamp at the camera.
float litLuminance(const SeenFace& face, int corner, const PictureView& view, bool isBack)
{
    const glm::vec3& normal = face.normals[corner];
    const float length = glm::length(normal);
    if (!(length > 0.0f)) return face.luminances[corner];
    float towards = glm::dot(normal, glm::vec3(view.towardsEye)) / length;
    if (isBack && face.material.isLitFromBothSides) towards = -towards;
    return face.luminances[corner] * (kAmbient + (1.0f - kAmbient) * std::max(0.0f, towards));
}

float texelAt(const MaterialLook& look, const glm::vec2& at)
{
    const auto wrapped = [](float x, std::uint32_t size) {
        return std::min(static_cast<std::uint32_t>((x - std::floor(x)) * static_cast<float>(size)), size - 1);
    };
    const std::uint32_t x = wrapped(at.x, look.texelsWide), y = wrapped(at.y, look.texelsHigh);
    return static_cast<float>(look.texels[std::size_t{y} * look.texelsWide + x]) / 255.0f;
}

} // namespace

FragmentPicture::FragmentPicture(const PictureView& view, int sizePx, float background)
    : _view(view), _sizePx(sizePx), _background(background)
{
    const std::size_t pixels = std::size_t(sizePx) * std::size_t(sizePx);
    _first.assign(pixels, ~0u);
    _luminance.assign(pixels, background);
    _newDepth.assign(pixels, 0.0f);
    _newLuminance.assign(pixels, 0.0f);
    _round.assign(pixels, 0);
}

/// Calls `visit(pixel, depth, luminance)` for the pixels that a face covers in this view, hidden or not.
template<class Visit>
void FragmentPicture::draw(const SeenFace& face, const Visit& visit) const
{
    std::array<glm::dvec3, 3> at;
    for (int i = 0; i < 3; ++i)
        at[i] = {(glm::dot(face.corners[i], _view.right) + 0.5) * _sizePx,
                 (glm::dot(face.corners[i], _view.up) + 0.5) * _sizePx,
                 glm::dot(face.corners[i], _view.towardsEye)};
    const bool isBack = (at[1].x - at[0].x) * (at[2].y - at[0].y) < (at[1].y - at[0].y) * (at[2].x - at[0].x);
    if (isBack && !face.material.isTwoSided) return;
    const glm::dvec3 depths(at[0].z, at[1].z, at[2].z);
    const glm::vec3 lit(litLuminance(face, 0, _view, isBack), litLuminance(face, 1, _view, isBack),
                        litLuminance(face, 2, _view, isBack));
    rasterise(at, _sizePx,
              [&](std::uint32_t pixel, const glm::dvec3& shares)
              {
                  if (face.material.isTransparent &&
                      ((pixel + pixel / static_cast<std::uint32_t>(_sizePx)) & 1u) != 0)
                      return;
                  float luminance = glm::dot(lit, glm::vec3(shares));
                  if (!face.material.look->texels.empty())
                      luminance *= texelAt(*face.material.look, float(shares.x) * face.texCoords[0] +
                                                                    float(shares.y) * face.texCoords[1] +
                                                                    float(shares.z) * face.texCoords[2]);
                  visit(pixel, static_cast<float>(glm::dot(depths, shares)), luminance);
              });
}

void FragmentPicture::updatePixel(std::uint32_t pixel)
{
    float nearest = kFarthest;
    _luminance[pixel] = _background;
    for (std::uint32_t f = _first[pixel]; f != ~0u; f = _fragments[f].next)
        if (_fragments[f].depth > nearest)
        {
            nearest = _fragments[f].depth;
            _luminance[pixel] = _fragments[f].luminance;
        }
}

void FragmentPicture::add(const SeenFace& face)
{
    draw(face,
         [&](std::uint32_t pixel, float depth, float luminance)
         {
             std::uint32_t number = _free;
             if (number == ~0u)
             {
                 number = static_cast<std::uint32_t>(_fragments.size());
                 _fragments.emplace_back();
             }
             else
                 _free = _fragments[number].next;
             _fragments[number] = {face.number, _first[pixel], depth, luminance};
             _first[pixel] = number;
             updatePixel(pixel);
         });
}

void FragmentPicture::remove(const SeenFace& face)
{
    draw(face,
         [&](std::uint32_t pixel, float, float)
         {
             std::uint32_t* at = &_first[pixel];
             while (*at != ~0u && _fragments[*at].face != face.number)
                 at = &_fragments[*at].next;
             if (*at == ~0u) return;
             const std::uint32_t gone = *at;
             *at = _fragments[gone].next;
             _fragments[gone].next = _free;
             _free = gone;
             updatePixel(pixel);
         });
}

double FragmentPicture::squaredError() const
{
    double sum = 0.0;
    for (std::size_t pixel = 0; pixel < _luminance.size(); ++pixel)
        sum += squared(_luminance[pixel] - _reference[pixel]);
    return sum;
}

double FragmentPicture::change(std::span<const SeenFace> removed, std::span<const SeenFace> added,
                               const FaceMarks& isRemoved)
{
    ++_currentRound;
    _touched.clear();
    const auto touch = [&](std::uint32_t pixel)
    {
        if (_round[pixel] == _currentRound) return;
        _round[pixel] = _currentRound;
        _newDepth[pixel] = kFarthest;
        _newLuminance[pixel] = _background;
        _touched.push_back(pixel);
    };
    for (const SeenFace& face : removed)
        draw(face, [&](std::uint32_t pixel, float, float) { touch(pixel); });
    for (const SeenFace& face : added)
        draw(face,
             [&](std::uint32_t pixel, float depth, float luminance)
             {
                 touch(pixel);
                 if (depth <= _newDepth[pixel]) return;
                 _newDepth[pixel] = depth;
                 _newLuminance[pixel] = luminance;
             });
    double growth = 0.0;
    for (const std::uint32_t pixel : _touched)
    {
        float nearest = _newDepth[pixel], luminance = _newLuminance[pixel];
        for (std::uint32_t f = _first[pixel]; f != ~0u; f = _fragments[f].next)
            if (_fragments[f].depth > nearest && !isRemoved.has(_fragments[f].face))
            {
                nearest = _fragments[f].depth;
                luminance = _fragments[f].luminance;
            }
        growth += squared(luminance - _reference[pixel]) - squared(_luminance[pixel] - _reference[pixel]);
    }
    return growth;
}

} // namespace osgPMObjects::core
