// SPDX-License-Identifier: Apache-2.0
#include "view/PictureQuality.h"

#include <algorithm>

namespace trainer
{

void PictureQuality::beginCoarse()
{
    if (_choosesQuality) _quality = Quality::low;
    if (_choosesTolerance) _tolerancePx = kMost * _askedPx;
}

bool PictureQuality::add(double pictureMs)
{
    if (++_count == 0) return false;
    _sumMs += pictureMs;
    const bool isSlow = _sumMs > kSlowMs * kPictures; // whatever the rest of them take
    if (_count < kPictures && !isSlow) return false;
    const double meanMs = _sumMs / _count;
    _sumMs = 0.0;
    _count = 0;
    const bool changes = changeQuality(meanMs) || changeTolerance(meanMs);
    if (changes) _count = -1;
    return changes;
}

bool PictureQuality::changeQuality(double meanMs)
{
    if (!_choosesQuality) return false;
    const Quality before = _quality;
    if (meanMs > kSlowMs && before != Quality::low)
        _quality = before == Quality::high ? Quality::medium : Quality::low;
    if (meanMs < kVeryQuickMs && _tolerancePx == _askedPx && before != Quality::high)
        _quality = before == Quality::low ? Quality::medium : Quality::high;
    return _quality != before;
}

bool PictureQuality::changeTolerance(double meanMs)
{
    if (!_choosesTolerance) return false;
    const double before = _tolerancePx;
    if (meanMs > kSlowMs) _tolerancePx = std::min(kStep * _tolerancePx, kMost * _askedPx);
    if (meanMs < kQuickMs) _tolerancePx = std::max(_tolerancePx / kStep, _askedPx);
    return _tolerancePx != before;
}

} // namespace trainer
