// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "FragmentPicture.h"

namespace osgPMObjects::core
{

/// The images of a model from all around, each with a reference image.
class PictureRing
{
public:
    PictureRing(const PolishSettings& settings, std::size_t faceCount);

    /// Draws faces into all images. Threads: one for each share of the views.
    void addAll(std::span<const SeenFace> faces);
    void setReference(const PictureRing& ring);

    /// The sum of squared luminance differences over all pixels of all views.
    double squaredError() const;

    /// The change of squaredError() if some faces were replaced by others; a number may be in both.
    /// Cost: linear in the pixels of these faces and their layers.
    double change(std::span<const SeenFace> removed, std::span<const SeenFace> added);
    void replace(std::span<const SeenFace> removed, std::span<const SeenFace> added);

private:
    std::vector<FragmentPicture> _pictures;
    FaceMarks _removed;
};

} // namespace osgPMObjects::core
