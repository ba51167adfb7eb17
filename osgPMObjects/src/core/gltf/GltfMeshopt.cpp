// SPDX-License-Identifier: Apache-2.0
#include "GltfMeshopt.h"

#include <optional>

#include <meshoptimizer.h>
#include <tiny_gltf.h>

namespace osgPMObjects::core
{

namespace
{

/// One compressed view, as its extension describes it.
struct CompressedView
{
    const unsigned char* first = nullptr;
    std::size_t bytes = 0, stride = 0, count = 0;
    std::string mode, filter;
};

/// Returns an unsigned member, `missing` where there is none.
std::size_t sizeIn(const tinygltf::Value& object, const char* member, std::size_t missing = 0)
{
    if (!object.Has(member) || !object.Get(member).IsNumber()) return missing;
    const double value = object.Get(member).GetNumberAsDouble();
    return value >= 0.0 && value < 4294967296.0 ? static_cast<std::size_t>(value) : missing;
}

std::string textIn(const tinygltf::Value& object, const char* member)
{
    return object.Has(member) && object.Get(member).IsString() ? object.Get(member).Get<std::string>()
                                                               : std::string();
}

std::optional<CompressedView> compressedView(const tinygltf::Model& model, const tinygltf::Value& extension)
{
    const std::size_t none = model.buffers.size(), number = sizeIn(extension, "buffer", none);
    if (number >= none) return {};
    const std::vector<unsigned char>& data = model.buffers[number].data;
    CompressedView view;
    const std::size_t offset = sizeIn(extension, "byteOffset");
    view.bytes = sizeIn(extension, "byteLength");
    view.stride = sizeIn(extension, "byteStride");
    view.count = sizeIn(extension, "count");
    view.mode = textIn(extension, "mode");
    view.filter = textIn(extension, "filter");
    if (offset > data.size() || view.bytes > data.size() - offset) return {};
    view.first = data.data() + offset;
    return view;
}

/// Tells whether the library's conditions hold, and whether so few bytes can hold so many elements: vertices
/// take at least two bits for 16 values of a byte, triangles one byte.
bool isSound(const CompressedView& view)
{
    constexpr std::size_t kMostRatio = 64, kTail = 1 << 16;
    const bool isVertices = view.mode == "ATTRIBUTES";
    if (isVertices ? view.stride == 0 || view.stride % 4 != 0 || view.stride > 256
                   : view.stride != 2 && view.stride != 4)
        return false;
    if (view.mode == "TRIANGLES" && view.count % 3 != 0) return false;
    return view.count <= (kMostRatio * view.bytes + kTail) / view.stride;
}

bool decode(const CompressedView& view, std::vector<unsigned char>& into)
{
    into.resize(view.count * view.stride);
    if (view.count == 0) return true;
    if (view.mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(into.data(), view.count, view.stride, view.first, view.bytes) == 0;
    if (view.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(into.data(), view.count, view.stride, view.first, view.bytes) == 0;
    return view.mode == "INDICES" &&
           meshopt_decodeIndexSequence(into.data(), view.count, view.stride, view.first, view.bytes) == 0;
}

bool unfilter(const CompressedView& view, std::vector<unsigned char>& data)
{
    if (view.filter.empty() || view.filter == "NONE") return true;
    if (view.mode != "ATTRIBUTES") return false;
    if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8))
        meshopt_decodeFilterOct(data.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION" && view.stride == 8)
        meshopt_decodeFilterQuat(data.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(data.data(), view.count, view.stride);
    else
        return false;
    return true;
}

} // namespace

foundation::Outcome decompressViews(tinygltf::Model& model, const std::string& name)
{
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i)
        for (const std::string_view extension : kMeshoptExtensions)
        {
            const auto found = model.bufferViews[i].extensions.find(std::string(extension));
            if (found == model.bufferViews[i].extensions.end()) continue;
            const auto compressed = compressedView(model, found->second);
            tinygltf::Buffer whole;
            if (!compressed || !isSound(*compressed) || !decode(*compressed, whole.data) ||
                !unfilter(*compressed, whole.data))
                return foundation::Error{name,
                                         "buffer view " + std::to_string(i) + " is compressed by " +
                                             std::string(extension) + " and cannot be decompressed",
                                         "export the model again without compression"};
            tinygltf::BufferView& view = model.bufferViews[i];
            view.buffer = static_cast<int>(model.buffers.size());
            view.byteOffset = 0;
            view.byteLength = whole.data.size();
            view.byteStride = compressed->mode == "ATTRIBUTES" ? compressed->stride : 0;
            model.buffers.push_back(std::move(whole));
            break;
        }
    return foundation::success();
}

} // namespace osgPMObjects::core
