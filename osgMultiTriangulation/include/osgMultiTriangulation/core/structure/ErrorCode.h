// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace osgMultiTriangulation::core
{

/// The error that a 16-bit code stands for, in metres: 5 bits of exponent, 11 bits of mantissa; 2^-16 to 2^16
/// m, and 0.
inline float errorOfCode(std::uint16_t code)
{
    if (code == 0) return 0.0f;
    return std::ldexp(1.0f + static_cast<float>(code & 0x7ff) / 2048.0f, (code >> 11) - 16);
}

/// Returns the code of the least error that is not below `errorM`; that of the greatest for what is beyond.
/// Errors grow by less than 0.05 %, whole metres up to 2048 not at all.
inline std::uint16_t codeOfError(float errorM)
{
    if (!(errorM > 0.0f)) return 0;
    if (errorM <= std::ldexp(1.0f, -16)) return 1; // so that no error becomes 0
    if (errorM >= errorOfCode(0xffff)) return 0xffff;
    const auto bits = std::bit_cast<std::uint32_t>(errorM);
    const std::uint32_t cut = 23 - 11;
    return static_cast<std::uint16_t>(((bits + (1u << cut) - 1) >> cut) - ((127u - 16u) << 11));
}

} // namespace osgMultiTriangulation::core
