// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace trainer
{

/// Chooses how coarse terrain and roads may be, so that pictures come at ten a second and more: the tolerance grows while pictures take long, up to
/// four times what was asked for, and comes back while they are quick. Simulated time does not depend on it (decision 34). Units: pixels, ms.
/// Threads: one.
class PictureQuality
{
public:
    static constexpr double kSlowMs = 85.0, kQuickMs = 40.0, kStep = 1.5, kMost = 4.0;
    static constexpr int kPictures = 10; ///< over which it looks

    /// `tolerancePx`: asked for.
    explicit PictureQuality(double tolerancePx) : _askedPx(tolerancePx), _tolerancePx(tolerancePx) {}

    /// Takes the time of a picture. Returns whether the tolerance has changed.
    bool add(double pictureMs);

    double tolerancePx() const { return _tolerancePx; }

private:
    double _askedPx, _tolerancePx;
    double _sumMs = 0.0;
    int _count = -1; ///< the first picture makes meshes and compiles shaders
};

} // namespace trainer
