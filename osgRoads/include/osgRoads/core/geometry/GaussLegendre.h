// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace osgRoads::core
{

/// The integral of a function over [from, to] by the Gauss–Legendre rule of 5 points: exact for polynomials
/// of degree 9. `Value` needs + and multiplication by a number.
/// Source: Abramowitz & Stegun, *Handbook of Mathematical Functions*, 1964, table 25.4.
template<class Function>
auto integralOf(const Function& function, double from, double to)
{
    constexpr std::array<double, 3> kAbscissas = {0.0, 0.53846931010568309104, 0.90617984593866399280};
    constexpr std::array<double, 3> kWeights = {0.56888888888888888889, 0.47862867049936646804,
                                                0.23692688505618908751};
    const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
    auto sum = function(middle) * kWeights[0];
    for (std::size_t i = 1; i < kAbscissas.size(); ++i)
        sum = sum + (function(middle - half * kAbscissas[i]) + function(middle + half * kAbscissas[i])) *
                        kWeights[i];
    return sum * half;
}

} // namespace osgRoads::core
