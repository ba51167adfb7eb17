// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/Quality.h"

namespace trainer
{

/// Chooses the quality of pictures and how coarse terrain and roads may be, so that pictures come at ten a
/// second and more: while they take long the quality falls, then the tolerance grows up to four times what
/// was asked for; while they are quick both come back, the quality only while they are very quick, since the
/// next one may take three times as long. Simulated time does not depend on it (decision 34). Units: pixels,
/// ms.
/// Threads: one.
class PictureQuality
{
public:
    static constexpr double kSlowMs = 85.0, kQuickMs = 40.0, kVeryQuickMs = 25.0, kStep = 1.5, kMost = 4.0;
    static constexpr int kPictures = 10; ///< over which it looks, or fewer when these are slow already

    /// `tolerancePx`, `quality`: asked for, and whether they may change.
    explicit PictureQuality(double tolerancePx, bool choosesTolerance = true, Quality quality = Quality::high,
                            bool choosesQuality = false)
        : _askedPx(tolerancePx),
          _tolerancePx(tolerancePx),
          _quality(quality),
          _choosesTolerance(choosesTolerance),
          _choosesQuality(choosesQuality)
    {
    }

    /// Begins with what it would come to in the end where pictures are slow, of what may change.
    void beginCoarse();

    /// Takes the time of a picture. Returns whether the tolerance or the quality has changed.
    bool add(double pictureMs);

    double tolerancePx() const { return _tolerancePx; }
    Quality quality() const { return _quality; }

private:
    bool changeQuality(double meanMs);
    bool changeTolerance(double meanMs);

    double _askedPx, _tolerancePx;
    Quality _quality;
    bool _choosesTolerance, _choosesQuality;
    double _sumMs = 0.0;
    int _count = -1; ///< the first picture, and the first after a change, makes meshes and compiles shaders
};

} // namespace trainer
