// SPDX-License-Identifier: Apache-2.0
#include "view/PictureQuality.h"

#include <algorithm>

namespace trainer
{

bool PictureQuality::add(double pictureMs)
{
    if (++_count == 0) return false;
    _sumMs += pictureMs;
    if (_count < kPictures) return false;
    const double meanMs = _sumMs / kPictures, before = _tolerancePx;
    _sumMs = 0.0;
    _count = 0;
    if (meanMs > kSlowMs) _tolerancePx = std::min(kStep * _tolerancePx, kMost * _askedPx);
    if (meanMs < kQuickMs) _tolerancePx = std::max(_tolerancePx / kStep, _askedPx);
    return _tolerancePx != before;
}

} // namespace trainer
