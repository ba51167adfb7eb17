// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgTerrainROAM/core/heightfield/SampleTable.h>

#include "FloatNotLess.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kMostSteps = 8388606.0; // of 23 bits
constexpr int kFinestExponent = -10;     ///< of the quantum: 1 mm

} // namespace

SampleTable::SampleTable(const std::vector<float>& heightsM, Storage storage, double headroom)
{
    const auto [low, high] = std::minmax_element(heightsM.begin(), heightsM.end());
    _rangeM = double{*high} - double{*low};
    if (storage == Storage::exact)
    {
        for (const float h : heightsM)
            _exact.push_back({h, 0.0f, 0.0f});
        return;
    }
    pack(heightsM, 0.5 * (double{*high} + double{*low}), headroom * _rangeM);
}

void SampleTable::setRadiusRange(double leastM, double mostM)
{
    for (int code = 1; code < 255; ++code)
        _radiiM[static_cast<std::size_t>(code)] =
            floatNotLess(leastM * std::pow(mostM / leastM, (code - 1) / 253.0));
    _radiiM[255] = std::numeric_limits<float>::infinity();
}

void SampleTable::pack(const std::vector<float>& heightsM, double middleM, double rangeM)
{
    const int exponent =
        rangeM > 0.0 ? static_cast<int>(std::ceil(std::log2(rangeM / kMostSteps))) : kFinestExponent;
    const double quantum = std::ldexp(1.0, std::max(exponent, kFinestExponent));
    const double offset = quantum * std::round(middleM / quantum);
    _quantumM = static_cast<float>(quantum);
    _offsetM = static_cast<float>(offset);
    _samples.reserve(heightsM.size());
    for (const float h : heightsM)
        _samples.emplace_back().setSteps(steps(h));
}

std::uint16_t SampleTable::errorCode(double errorM) const
{
    if (errorM <= 0.0) return 0;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(floatNotLess(errorM));
    const std::uint32_t up = (bits + (1u << kErrorShift) - 1u) >> kErrorShift;
    return static_cast<std::uint16_t>(std::clamp(up, kErrorBias + 1u, kErrorBias + 0xffffu) - kErrorBias);
}

std::uint8_t SampleTable::radiusCode(double radiusM) const
{
    return static_cast<std::uint8_t>(std::lower_bound(_radiiM.begin(), _radiiM.end() - 1, radiusM) -
                                     _radiiM.begin());
}

float SampleTable::roundedUpError(double errorM) const
{
    return _samples.empty() ? floatNotLess(errorM) : decodedError(errorCode(errorM));
}

float SampleTable::roundedUpRadius(double radiusM) const
{
    return _samples.empty() ? floatNotLess(radiusM) : _radiiM[radiusCode(radiusM)];
}

void SampleTable::setBound(std::size_t index, float errorM, float radiusM)
{
    if (_samples.empty())
    {
        _exact[index].errorM = errorM;
        _exact[index].radiusM = radiusM;
        return;
    }
    _samples[index].error = errorCode(errorM);
    _samples[index].radius = radiusCode(radiusM);
}

std::int32_t SampleTable::steps(float heightM) const
{
    const double steps = (double{heightM} - double{_offsetM}) / double{_quantumM};
    return static_cast<std::int32_t>(std::lround(std::clamp(steps, -0.5 * kMostSteps, 0.5 * kMostSteps)));
}

void SampleTable::setHeight(std::size_t index, float heightM)
{
    if (_samples.empty())
        _exact[index].heightM = heightM;
    else
        _samples[index].setSteps(steps(heightM));
}

void SampleTable::setElsewhere(std::size_t index, bool elsewhere)
{
    if (_samples.empty()) return;
    std::uint8_t& rest = _samples[index].rest;
    rest = static_cast<std::uint8_t>(elsewhere ? rest | kElsewhere : rest & ~kElsewhere);
}

std::size_t SampleTable::memoryBytes() const
{
    return _samples.capacity() * sizeof(Packed) + _exact.capacity() * sizeof(Sample);
}

} // namespace osgTerrainROAM::core
