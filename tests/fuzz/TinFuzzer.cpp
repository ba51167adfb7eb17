// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a file of triangles: they become a TIN whose triangles have vertices, or are
// refused; on a lattice it is fit to be built from, or refused. The first byte tells the format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <osgMultiTriangulation/core/input/TinFile.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgMultiTriangulation::core;
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    const auto tin = data[0] % 3 == 0   ? parseObj(bytes, "fuzzed")
                     : data[0] % 3 == 1 ? parsePly(bytes, "fuzzed")
                                        : parseQuantizedMesh(bytes, "fuzzed");
    if (!tin) return 0;
    if (tin->triangles.empty()) std::abort();
    for (const Triangle& triangle : tin->triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= tin->points.size()) std::abort();
    const auto placed = placeTin(*tin, "fuzzed");
    if (!placed) return 0;
    for (const Triangle& t : placed->mesh.triangles)
        if (!(twiceArea(placed->mesh.points[t[0]], placed->mesh.points[t[1]], placed->mesh.points[t[2]]) >
              0.0))
            std::abort();
    return 0;
}
