// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "PictureView.h"
#include "SeenFace.h"

namespace osgPMObjects::core
{

/// A set of face numbers to leave out of an image.
struct FaceMarks
{
    std::vector<std::uint32_t> marks; ///< by face
    std::uint32_t current = 0;

    bool has(std::uint32_t face) const { return marks[face] == current; }
};

/// The luminance image of a model in one view, with all hidden layers: each pixel has a list of fragments of
/// all faces over its centre, so a face can be removed without drawing the others. Transparent faces cover
/// every other pixel (screen-door).
/// Invariant: a pixel has the luminance of its nearest fragment, or the background's.
/// Source: Carpenter, *The A-buffer, an antialiased hidden surface method* (1984), lists of fragments;
/// without subpixel masks.
/// Memory: 16 B a fragment, 24 B a pixel.
class FragmentPicture
{
public:
    FragmentPicture(const PictureView& view, int sizePx, float background);

    void add(const SeenFace& face);
    /// Removes a face, which must have the corners with which it was added.
    void remove(const SeenFace& face);

    /// The luminance of each pixel, row by row from below.
    const std::vector<float>& luminances() const { return _luminance; }

    /// Sets the reference: what another image of the same view shows.
    void setReference(const FragmentPicture& picture) { _reference = picture._luminance; }
    /// The sum of squared luminance differences to the reference.
    double squaredError() const;

    /// The change of squaredError() if some faces, marked in `isRemoved`, were replaced by others.
    double change(std::span<const SeenFace> removed, std::span<const SeenFace> added,
                  const FaceMarks& isRemoved);

private:
    struct Fragment
    {
        std::uint32_t face = 0;
        std::uint32_t next = ~0u;
        float depth = 0.0f; ///< towards the camera
        float luminance = 0.0f;
    };

    template<class Visit>
    void draw(const SeenFace& face, const Visit& visit) const;
    void updatePixel(std::uint32_t pixel);

    PictureView _view;
    int _sizePx;
    float _background;
    std::vector<Fragment> _fragments;
    std::uint32_t _free = ~0u;
    std::vector<std::uint32_t> _first; ///< by pixel
    std::vector<float> _luminance, _reference;
    // of change(), kept to reuse their memory
    std::vector<float> _newDepth, _newLuminance;
    std::vector<std::uint32_t> _touched, _round;
    std::uint32_t _currentRound = 0;
};

} // namespace osgPMObjects::core
