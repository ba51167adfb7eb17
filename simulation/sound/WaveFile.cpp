// SPDX-License-Identifier: Apache-2.0
#include "simulation/sound/WaveFile.h"

#include <cerrno>
#include <cmath>
#include <string>

namespace simulation
{

namespace
{

constexpr std::uint64_t kMostWaveBytes = 0xFFFFFFFFU - 64U;

void addNumber(std::string& text, std::uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(value >> (8 * i) & 0xFFU);
}

} // namespace

WaveFile::WaveFile(const std::filesystem::path& file, int rate)
    : _file(file), _stream(_file.written(), std::ios::binary), _rate(rate)
{
    writeHead();
}

/// With the lengths so far.
void WaveFile::writeHead()
{
    const auto bytes = static_cast<std::uint32_t>(_bytes);
    std::string head = "RIFF";
    addNumber(head, bytes + 36U, 4);
    head += "WAVEfmt ";
    addNumber(head, 16U, 4);
    addNumber(head, 1U, 2); // whole numbers
    addNumber(head, 2U, 2); // channels
    addNumber(head, static_cast<std::uint32_t>(_rate), 4);
    addNumber(head, static_cast<std::uint32_t>(_rate) * 4U, 4);
    addNumber(head, 4U, 2);
    addNumber(head, 16U, 2);
    head += "data";
    addNumber(head, bytes, 4);
    _stream.write(head.data(), static_cast<std::streamsize>(head.size()));
}

foundation::Outcome WaveFile::outcome() const
{
    if (_stream) return foundation::success();
    return _file.failure("cannot be written", std::generic_category().message(errno != 0 ? errno : EIO));
}

foundation::Outcome WaveFile::add(std::span<const float> samples)
{
    std::string bytes;
    bytes.reserve(2 * samples.size());
    for (const float sample : samples)
        addNumber(
            bytes,
            static_cast<std::uint32_t>(std::lround(32767.0F * std::fmin(std::fmax(sample, -1.0F), 1.0F))), 2);
    if (_bytes + bytes.size() > kMostWaveBytes)
        return _file.failure("cannot be written", "a WAVE file holds 4 GiB");
    errno = 0;
    _stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    _bytes += bytes.size();
    return outcome();
}

foundation::Outcome WaveFile::finish()
{
    errno = 0;
    _stream.seekp(0);
    writeHead();
    _stream.close();
    if (const auto written = outcome(); !written) return written;
    return _file.commit();
}

} // namespace simulation
