// SPDX-License-Identifier: Apache-2.0
// A small glTF in text, for tests and fuzzers' seeds: a triangle with normals, indices and a mirrored node.
#pragma once

#include <string>

namespace testsupport
{

/// The triangle (0,0,0), (1,0,0), (0,1,0) facing +z; `extra` goes into its primitive, `node` into its node.
inline std::string gltfText(const std::string& node = "", const std::string& extra = "")
{
    // 3 × 12 B positions, 3 × 2 B indices
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node +
           R"(}],"meshes":[{"name":"tri","primitives":[{"attributes":{"POSITION":0},"indices":1)" + extra +
           R"(}]}],"materials":[{"name":"paint","doubleSided":true}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,)"
           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"
           R"("}]})";
}

} // namespace testsupport
