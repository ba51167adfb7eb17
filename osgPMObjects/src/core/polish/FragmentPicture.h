// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "PictureView.h"
#include "SeenFace.h"

namespace osgPMObjects::core
{

/// Faces that are left out of a picture, by number.
struct FaceMarks
{
    std::vector<std::uint32_t> marks; ///< by face
    std::uint32_t current = 0;

    bool has(std::uint32_t face) const { return marks[face] == current; }
};

/// The luminance of a model in one view, with everything that lies behind: each pixel has a list of all faces over its centre, so a face can
/// be taken out without drawing the others. Transparent faces cover every other pixel, like a chequerboard.
/// Invariant: a pixel's luminance is that of its nearest fragment, or the background's.
/// Memory: 16 B a fragment, 24 B a pixel.
class FragmentPicture
{
public:
    FragmentPicture(const PictureView& view, int sizePx, float background);

    void add(const SeenFace& face);
    /// The face has to be as it was when it was added.
    void remove(const SeenFace& face);

    /// What shall be seen: what another picture of the same view shows.
    void setReference(const FragmentPicture& picture) { _reference = picture._luminance; }
    /// Sum of the squared differences to the reference.
    double squaredError() const;

    /// By how much squaredError() would grow if some faces, which `isRemoved` marks, gave way to others.
    double change(std::span<const SeenFace> removed, std::span<const SeenFace> added,
                  const FaceMarks& isRemoved);

private:
    struct Fragment
    {
        std::uint32_t face = 0;
        std::uint32_t next = ~0u;
        float depth = 0.0f; ///< towards the eye
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
    // of change(), kept for their memory
    std::vector<float> _newDepth, _newLuminance;
    std::vector<std::uint32_t> _touched, _round;
    std::uint32_t _currentRound = 0;
};

} // namespace osgPMObjects::core
