// SPDX-License-Identifier: Apache-2.0
#include "PictureRing.h"

#include <osgPMObjects/core/Parallel.h>

namespace osgPMObjects::core
{

PictureRing::PictureRing(const PolishSettings& settings, std::size_t faceCount)
{
    for (const PictureView& view : viewsAround(settings.views))
        _pictures.emplace_back(view, settings.sizePx, settings.background);
    _removed.marks.assign(faceCount, 0);
}

void PictureRing::addAll(std::span<const SeenFace> faces)
{
    parallelShares(_pictures.size(), 1,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t i = first; i < last; ++i)
                           for (const SeenFace& face : faces)
                               _pictures[i].add(face);
                   });
}

void PictureRing::setReference(const PictureRing& ring)
{
    for (std::size_t i = 0; i < _pictures.size(); ++i)
        _pictures[i].setReference(ring._pictures[i]);
}

double PictureRing::squaredError() const
{
    double sum = 0.0;
    for (const FragmentPicture& picture : _pictures)
        sum += picture.squaredError();
    return sum;
}

double PictureRing::change(std::span<const SeenFace> removed, std::span<const SeenFace> added)
{
    ++_removed.current;
    for (const SeenFace& face : removed)
        _removed.marks[face.number] = _removed.current;
    double growth = 0.0;
    for (FragmentPicture& picture : _pictures)
        growth += picture.change(removed, added, _removed);
    return growth;
}

void PictureRing::replace(std::span<const SeenFace> removed, std::span<const SeenFace> added)
{
    for (FragmentPicture& picture : _pictures)
    {
        for (const SeenFace& face : removed)
            picture.remove(face);
        for (const SeenFace& face : added)
            picture.add(face);
    }
}

} // namespace osgPMObjects::core
