// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTerrainROAM::core
{

/// How a tile keeps its samples.
enum class Storage
{
    compact, ///< 6 B a sample, heights in steps of a quantum, bounds rounded up
    exact,   ///< 12 B a sample, floats: for comparisons with published figures
};

/// How many times the range of its heights a table keeps where edits may lie.
inline constexpr double kEditHeadroom = 2.0;

/// What a tile keeps of each data sample: its height, and error and radius of the bintree vertex there (ErrorTree).
/// Compact: 16-bit heights in steps of heightQuantumM(), a power of two: heights that are multiples of it, whole metres
/// among them, are kept exactly. Errors have 5 bits of exponent and 11 of mantissa, radii 253 logarithmic steps; both are
/// rounded up. All of a sample lies side by side: who looks at a vertex misses the cache once.
/// Sample `index` is row·columns + column. Units: metres.
class SampleTable
{
public:
    /// `headroom`: how many times the heights' own range can be kept, compact.
    SampleTable(const std::vector<float>& heightsM, Storage storage, double headroom = 1.0);

    /// Which radii can be told apart, once the samples have places: from a fraction of a cell to several tiles.
    void setRadiusRange(double leastM, double mostM);

    float heightM(std::size_t index) const
    {
        return _samples.empty() ? _exact[index].heightM : _offsetM + _quantumM * _samples[index].height;
    }

    /// All of a sample in one read.
    struct Sample
    {
        float heightM, errorM, radiusM;
    };
    Sample sample(std::size_t index) const
    {
        if (_samples.empty()) return _exact[index];
        const Packed& packed = _samples[index];
        return {_offsetM + _quantumM * packed.height, decodedError(packed.error), _radiiM[packed.radius]};
    }

    /// The same, unless its data are elsewhere: false.
    bool read(std::size_t index, Sample& sample) const
    {
        if (_samples.empty())
        {
            sample = _exact[index];
            return true;
        }
        const Packed& packed = _samples[index];
        sample = {_offsetM + _quantumM * packed.height, decodedError(packed.error), _radiiM[packed.radius]};
        return packed.flags == 0;
    }

    /// Tells the processor that a sample will be asked for.
    void prefetch(std::size_t index) const
    {
        __builtin_prefetch(_samples.empty() ? static_cast<const void*>(&_exact[index]) : &_samples[index]);
    }

    /// The least values that can be kept and are not less.
    float roundedUpError(double errorM) const;
    float roundedUpRadius(double radiusM) const;

    /// Keeps what roundedUp…() gave.
    void setBound(std::size_t index, float errorM, float radiusM);

    /// Keeps a height as well as it can: to the nearest step, or the end of the range.
    void setHeight(std::size_t index, float heightM);

    /// Whether a sample's data are to be found elsewhere (FineSamples).
    bool isElsewhere(std::size_t index) const { return !_samples.empty() && _samples[index].flags != 0; }
    void setElsewhere(std::size_t index, bool elsewhere);

    double heightQuantumM() const { return _quantumM; } ///< heights are off by at most half of it; 0: exact
    double heightRangeM() const { return _rangeM; }     ///< from the lowest to the highest
    std::size_t size() const { return _samples.size() + _exact.size(); }
    std::size_t memoryBytes() const;

private:
    struct Packed
    {
        std::int16_t height;
        std::uint16_t error;
        std::uint8_t radius;
        std::uint8_t flags; ///< 1: FineSamples has it
    };
    static_assert(sizeof(Packed) == 6);

    /// A float's bits without sign, its exponents from 2^-14 on, and the lower twelve of its mantissa.
    static constexpr std::uint32_t kErrorBias = (127u - 14u) << 11;
    static constexpr int kErrorShift = 12;

    static float decodedError(std::uint16_t code)
    {
        return code == 0 ? 0.0f : std::bit_cast<float>((code + kErrorBias) << kErrorShift);
    }

    void pack(const std::vector<float>& heightsM, double middleM, double rangeM);
    std::int16_t steps(float heightM) const;
    std::uint16_t errorCode(double errorM) const;
    std::uint8_t radiusCode(double radiusM) const;

    double _rangeM = 0.0;
    float _offsetM = 0.0f, _quantumM = 0.0f;
    std::array<float, 256> _radiiM{}; ///< by code; the first is 0, the last infinite
    std::vector<Packed> _samples;     ///< compact
    std::vector<Sample> _exact;
};

} // namespace osgTerrainROAM::core
