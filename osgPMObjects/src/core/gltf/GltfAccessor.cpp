// SPDX-License-Identifier: Apache-2.0
#include "GltfAccessor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <tiny_gltf.h>

namespace osgPMObjects::core
{

namespace
{

/// The bytes of an accessor, checked against its buffer.
struct Bytes
{
    const unsigned char* first = nullptr;
    std::size_t stride = 0, count = 0;
    int components = 0, type = 0;
    bool isNormalised = false;
};

template<class Entry>
const Entry* entryAt(const std::vector<Entry>& entries, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < entries.size()
               ? &entries[static_cast<std::size_t>(index)]
               : nullptr;
}

std::optional<Bytes> bytesOf(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor* accessor = entryAt(model.accessors, index);
    if (!accessor || accessor->sparse.isSparse) return {};
    const tinygltf::BufferView* view = entryAt(model.bufferViews, accessor->bufferView);
    const tinygltf::Buffer* buffer = view ? entryAt(model.buffers, view->buffer) : nullptr;
    if (!buffer) return {};
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor->componentType));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor->type));
    if (size <= 0 || components <= 0 || components > 4) return {};
    const std::size_t element = static_cast<std::size_t>(size) * static_cast<std::size_t>(components);
    const std::size_t stride = view->byteStride == 0 ? element : view->byteStride;
    const std::size_t all = buffer->data.size();
    if (stride < element || view->byteOffset > all || accessor->byteOffset > all - view->byteOffset)
        return {};
    const std::size_t room = all - view->byteOffset - accessor->byteOffset;
    if (accessor->count == 0) return Bytes{};
    if (element > room || accessor->count - 1 > (room - element) / stride) return {};
    return Bytes{buffer->data.data() + view->byteOffset + accessor->byteOffset,
                 stride,
                 accessor->count,
                 components,
                 accessor->componentType,
                 accessor->normalized};
}

template<class T>
double valueAt(const unsigned char* place, bool isNormalised)
{
    T value;
    std::memcpy(&value, place, sizeof value);
    if constexpr (std::is_integral_v<T>)
        if (isNormalised)
            return std::max(-1.0,
                            static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()));
    return static_cast<double>(value);
}

double componentAt(const Bytes& bytes, std::size_t element, int component)
{
    const auto place = [&](std::size_t size)
    { return bytes.first + element * bytes.stride + static_cast<std::size_t>(component) * size; };
    switch (bytes.type)
    {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return valueAt<std::int8_t>(place(1), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return valueAt<std::uint8_t>(place(1), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return valueAt<std::int16_t>(place(2), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return valueAt<std::uint16_t>(place(2), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_INT:
        return valueAt<std::int32_t>(place(4), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return valueAt<std::uint32_t>(place(4), bytes.isNormalised);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return valueAt<float>(place(4), false);
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
        return valueAt<double>(place(8), false);
    default:
        return 0.0;
    }
}

} // namespace

std::optional<std::vector<glm::dvec4>> accessorValues(const tinygltf::Model& model, int accessor)
{
    const auto bytes = bytesOf(model, accessor);
    if (!bytes) return {};
    std::vector<glm::dvec4> values(bytes->count, glm::dvec4(0.0, 0.0, 0.0, 1.0));
    for (std::size_t i = 0; i < bytes->count; ++i)
        for (int c = 0; c < bytes->components; ++c)
            values[i][c] = componentAt(*bytes, i, c);
    return values;
}

std::optional<std::vector<std::uint32_t>> accessorIndices(const tinygltf::Model& model, int accessor)
{
    const auto bytes = bytesOf(model, accessor);
    const bool isUnsigned =
        bytes && (bytes->count == 0 || bytes->type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                  bytes->type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                  bytes->type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    if (!isUnsigned || bytes->components > 1) return {};
    std::vector<std::uint32_t> indices(bytes->count);
    for (std::size_t i = 0; i < bytes->count; ++i)
        indices[i] = static_cast<std::uint32_t>(componentAt(*bytes, i, 0));
    return indices;
}

} // namespace osgPMObjects::core
