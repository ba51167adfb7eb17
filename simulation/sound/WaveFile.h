// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <span>

#include <foundation/Result.h>
#include <foundation/WholeFile.h>

namespace simulation
{

/// Writes sound as a WAVE file of 16 bits and two channels; it has its name when finish() has written its
/// head. Threads: one.
/// Source: Microsoft and IBM, *Multimedia Programming Interface and Data Specifications 1.0*, 1991, chapter
/// 3.
class WaveFile
{
public:
    /// `rate`: samples a second of each channel.
    WaveFile(const std::filesystem::path& file, int rate);

    /// `samples`: left, right, left, … within -1…1. Errors: no room, no folder; more than 4 GiB.
    foundation::Outcome add(std::span<const float> samples);

    /// Errors: as add().
    foundation::Outcome finish();

private:
    void writeHead();
    foundation::Outcome outcome() const;

    foundation::WholeFile _file;
    std::ofstream _stream;
    int _rate;
    std::uint64_t _bytes = 0; ///< of samples
};

} // namespace simulation
