// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace osgTerrainROAM
{

/// A square, periodic field of gradient noise summed over octaves, scaled to mean ½ and a standard deviation
/// of 1/6 and clamped to 0…1. The same parameters give the same field, everywhere.
/// Source: Perlin, "Improving noise" (2002), on a periodic lattice; the gradients come from an integer hash.
class TileableNoise
{
public:
    struct Octaves
    {
        int firstFrequency; ///< lattice cells per period in the first octave; doubles with each
        int count;
        double persistence; ///< amplitude of an octave relative to the one before
        std::uint32_t seed;
    };

    TileableNoise(int side, const Octaves& octaves);

    int side() const { return _side; }
    /// The value of a texel; indices wrap.
    float at(int x, int y) const
    {
        return _values[static_cast<std::size_t>(y & (_side - 1)) * _side + (x & (_side - 1))];
    }
    /// The value at a position, interpolated bilinearly; one period is 1.
    float sample(double u, double v) const;

private:
    void addOctave(int frequency, double amplitude, std::uint32_t seed);
    void normalize();

    int _side; ///< a power of two
    std::vector<float> _values;
};

} // namespace osgTerrainROAM
