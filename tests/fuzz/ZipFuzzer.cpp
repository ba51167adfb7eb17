// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a zip archive, or as something packed by gzip: each file in it is unpacked, or is
// refused with a reason.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <zlib.h>

#include "simulation/track/ZipArchive.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto rank = [](std::string_view name) { return name.ends_with(".txt") ? -1 : 0; };
    simulation::forEachFileOfZip(bytes, rank,
                                 [](const simulation::ZipFile& file)
                                 {
                                     if (file.text.has_value() != file.reason.empty()) std::abort();
                                     return false;
                                 });
    constexpr int kGzip = 16;
    const auto text = simulation::inflated(bytes, kGzip + MAX_WBITS);
    if (text && text->size() > simulation::kMostUnpackedBytes + (1U << 16)) std::abort();
    return 0;
}
