// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "FragmentPicture.h"

namespace osgPMObjects::core
{

/// Pictures of one model from all around, beside those of what it shall look like.
class PictureRing
{
public:
    PictureRing(const PolishSettings& settings, std::size_t faceCount);

    /// Draws faces into all pictures. Threads: one for each share of the views.
    void addAll(std::span<const SeenFace> faces);
    void setReference(const PictureRing& ring);

    /// Sum of the squared differences in luminance over all pixels of all views.
    double squaredError() const;

    /// By how much squaredError() would grow if some faces gave way to others; numbers may be in both.
    /// Cost: linear in the pixels of these faces, and the layers there.
    double change(std::span<const SeenFace> removed, std::span<const SeenFace> added);
    void replace(std::span<const SeenFace> removed, std::span<const SeenFace> added);

private:
    std::vector<FragmentPicture> _pictures;
    FaceMarks _removed;
};

} // namespace osgPMObjects::core
