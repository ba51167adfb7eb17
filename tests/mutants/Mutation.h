// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

/// Returns a file's bytes with damage that follows from the seed: flipped bits, a cut, a piece that is
/// missing or there twice, numbers exchanged for others or for extreme ones (as text, or as words of four
/// bytes).
std::string mutated(const std::string& bytes, std::uint32_t seed);
