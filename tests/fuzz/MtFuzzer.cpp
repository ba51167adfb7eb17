// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a tree of a .mt file: they become a valid multi-triangulation, or are refused.
// They are read in sections, and as one piece (version 1). The first byte tells the step of heights and how
// many fragments are wanted.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/file/TreeCode.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgMultiTriangulation::core;
    if (size == 0) return 0;
    const double step = (data[0] & 1) != 0 ? 1.0 / 64.0 : 0.0;
    const std::size_t fragments = (data[0] & 2) != 0 ? data[0] : std::numeric_limits<std::size_t>::max();
    const auto record = decodeTree({reinterpret_cast<const std::byte*>(data + 1), size - 1}, step, fragments);
    if (record && checkStructure(record->part)) std::abort();
    if (record && (data[0] & 2) == 0 && decodeTree(encodeTree(*record, step), step) != record) std::abort();
    const auto whole =
        decodeWholeTree({reinterpret_cast<const std::byte*>(data + 1), size - 1}, step, fragments);
    if (whole && checkStructure(whole->part)) std::abort();
    return 0;
}
