// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTerrainROAM::core
{

/// The format in which a tile keeps its samples.
enum class Storage
{
    compact, ///< 6 B a sample: heights quantised, bounds rounded up
    exact,   ///< 12 B a sample, floats: for comparisons with published figures
};

/// The range of heights that an editable table can keep, as a multiple of the range of its data.
inline constexpr double kEditHeadroom = 2.0;

/// A table of samples: the height of each, and error and radius of the bintree vertex there (ErrorTree).
/// Compact: 23-bit heights in steps of heightQuantumM(), a power of two: multiples of it, whole metres among
/// them, are kept exactly. The step is 1 mm (2^-10 m) up to a range of 8 km. Errors have 5 bits of exponent
/// and 11 of mantissa, radii 253 logarithmic steps; both are rounded up. The data of a sample are adjacent:
/// reading a vertex costs one cache miss at most. Sample `index` is row·columns + column. Units: metres.
class SampleTable
{
public:
    /// `headroom`: range of heights that the compact format can keep, as a multiple of the range of
    /// `heightsM`.
    SampleTable(const std::vector<float>& heightsM, Storage storage, double headroom = 1.0);

    /// Sets the range of radii that can be told apart: from a fraction of a cell to several tiles.
    void setRadiusRange(double leastM, double mostM);

    float heightM(std::size_t index) const
    {
        return _samples.empty() ? _exact[index].heightM : keptHeightM(_samples[index]);
    }

    /// The data of one sample.
    struct Sample
    {
        float heightM, errorM, radiusM;
    };
    Sample sample(std::size_t index) const
    {
        if (_samples.empty()) return _exact[index];
        const Packed& packed = _samples[index];
        return {keptHeightM(packed), decodedError(packed.error), _radiiM[packed.radius]};
    }

    /// Reads a sample. Returns false when its data are elsewhere (FineSamples).
    bool read(std::size_t index, Sample& sample) const
    {
        if (_samples.empty())
        {
            sample = _exact[index];
            return true;
        }
        const Packed& packed = _samples[index];
        sample = {keptHeightM(packed), decodedError(packed.error), _radiiM[packed.radius]};
        return !packed.isElsewhere();
    }

    /// Fetches a sample into the processor's cache.
    void prefetch(std::size_t index) const
    {
        __builtin_prefetch(_samples.empty() ? static_cast<const void*>(&_exact[index]) : &_samples[index]);
    }

    /// The least values that can be kept and are not less than the given ones.
    float roundedUpError(double errorM) const;
    float roundedUpRadius(double radiusM) const;

    /// Keeps an error and a radius that roundedUpError() and roundedUpRadius() gave.
    void setBound(std::size_t index, float errorM, float radiusM);

    /// Keeps a height, rounded to the nearest step and clamped to the range.
    void setHeight(std::size_t index, float heightM);

    /// Tells whether the data of a sample are elsewhere (FineSamples, SampleSheet).
    bool isElsewhere(std::size_t index) const { return !_samples.empty() && _samples[index].isElsewhere(); }
    void setElsewhere(std::size_t index, bool elsewhere);

    double heightQuantumM() const { return _quantumM; } ///< twice the largest error of a height; 0: exact
    double heightRangeM() const { return _rangeM; }     ///< from the lowest to the highest
    std::size_t size() const { return _samples.size() + _exact.size(); }
    std::size_t memoryBytes() const;

private:
    static constexpr int kLowerBits = 7;
    static constexpr std::uint8_t kElsewhere = 1 << kLowerBits;

    struct Packed
    {
        std::int16_t height; ///< in steps, without the lower kLowerBits
        std::uint16_t error;
        std::uint8_t radius;
        std::uint8_t rest; ///< the lower bits of the height; kElsewhere: the data are elsewhere

        std::int32_t steps() const { return height * (1 << kLowerBits) + (rest & ~kElsewhere); }
        bool isElsewhere() const { return (rest & kElsewhere) != 0; }
        void setSteps(std::int32_t steps)
        {
            height = static_cast<std::int16_t>(steps >> kLowerBits);
            rest = static_cast<std::uint8_t>((rest & kElsewhere) | (steps & ~(-1 << kLowerBits)));
        }
    };
    static_assert(sizeof(Packed) == 6);

    float keptHeightM(const Packed& packed) const
    {
        return _offsetM + _quantumM * static_cast<float>(packed.steps());
    }

    /// An error's code is the bits of a float without its sign, with exponents from 2^-14 on, and without the
    /// lower twelve bits.
    static constexpr std::uint32_t kErrorBias = (127u - 14u) << 11;
    static constexpr int kErrorShift = 12;

    static float decodedError(std::uint16_t code)
    {
        return code == 0 ? 0.0f : std::bit_cast<float>((code + kErrorBias) << kErrorShift);
    }

    void pack(const std::vector<float>& heightsM, double middleM, double rangeM);
    std::int32_t steps(float heightM) const;
    std::uint16_t errorCode(double errorM) const;
    std::uint8_t radiusCode(double radiusM) const;

    double _rangeM = 0.0;
    float _offsetM = 0.0f, _quantumM = 0.0f;
    std::array<float, 256> _radiiM{}; ///< by code; the first is 0, the last infinite
    std::vector<Packed> _samples;     ///< compact
    std::vector<Sample> _exact;
};

} // namespace osgTerrainROAM::core
