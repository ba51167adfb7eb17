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
    if (_choosesQuality && meanMs > kSlowMs && _quality != Quality::low)
    {
        _quality = _quality == Quality::high ? Quality::medium : Quality::low;
        return true;
    }
    if (_choosesQuality && meanMs < kVeryQuickMs && before == _askedPx && _quality != Quality::high)
    {
        _quality = _quality == Quality::low ? Quality::medium : Quality::high;
        return true;
    }
    if (!_choosesTolerance) return false;
    if (meanMs > kSlowMs) _tolerancePx = std::min(kStep * _tolerancePx, kMost * _askedPx);
    if (meanMs < kQuickMs) _tolerancePx = std::max(_tolerancePx / kStep, _askedPx);
    return _tolerancePx != before;
}

} // namespace trainer
