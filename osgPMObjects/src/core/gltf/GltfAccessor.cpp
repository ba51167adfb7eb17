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

/// What elements of an array are, and how many.
struct Kind
{
    int type = 0, components = 0;
    std::size_t count = 0;
    bool isNormalised = false;
};

/// Returns an array in a buffer view; empty where view or buffer are shorter than it.
std::optional<Bytes> bytesIn(const tinygltf::Model& model, int viewNumber, std::size_t offset,
                             const Kind& kind)
{
    const tinygltf::BufferView* view = entryAt(model.bufferViews, viewNumber);
    const tinygltf::Buffer* buffer = view ? entryAt(model.buffers, view->buffer) : nullptr;
    if (!buffer) return {};
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(kind.type));
    if (size <= 0 || kind.components <= 0 || kind.components > 4) return {};
    const std::size_t element = static_cast<std::size_t>(size) * static_cast<std::size_t>(kind.components);
    const std::size_t stride = view->byteStride == 0 ? element : view->byteStride;
    const std::size_t all = buffer->data.size();
    if (stride < element || view->byteOffset > all) return {};
    const std::size_t ofView = std::min(all - view->byteOffset, view->byteLength);
    if (offset > ofView) return {};
    const std::size_t room = ofView - offset;
    if (kind.count == 0) return Bytes{};
    if (element > room || kind.count - 1 > (room - element) / stride) return {};
    return Bytes{buffer->data.data() + view->byteOffset + offset,
                 stride,
                 kind.count,
                 kind.components,
                 kind.type,
                 kind.isNormalised};
}

Kind kindOf(const tinygltf::Accessor& accessor)
{
    return {accessor.componentType,
            tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)), accessor.count,
            accessor.normalized};
}

/// A sparse accessor without values of its own, or one that only stands for data of an extension, is one of
/// zeros. A view of no bytes is none (prepareExtensions()).
bool isOfZeros(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const tinygltf::BufferView* view = entryAt(model.bufferViews, accessor.bufferView);
    return accessor.bufferView < 0 || (accessor.sparse.isSparse && view && view->byteLength == 0);
}

bool isIndexType(int type)
{
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
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

/// Puts an array into `values`, at its own places or, with `places`, at those. False: a place is none of
/// theirs.
bool put(const Bytes& bytes, const Bytes* places, std::vector<glm::dvec4>& values)
{
    for (std::size_t i = 0; i < bytes.count; ++i)
    {
        const double place = places ? componentAt(*places, i, 0) : static_cast<double>(i);
        if (place >= static_cast<double>(values.size())) return false;
        for (int c = 0; c < bytes.components; ++c)
            values[static_cast<std::size_t>(place)][c] = componentAt(bytes, i, c);
    }
    return true;
}

/// Replaces the values that a sparse accessor lists.
bool putSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
               std::vector<glm::dvec4>& values)
{
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) return false;
    if (sparse.count == 0) return true;
    Kind kind = kindOf(accessor);
    kind.count = static_cast<std::size_t>(sparse.count);
    const auto places =
        bytesIn(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                {sparse.indices.componentType, 1, kind.count, false});
    const auto with =
        bytesIn(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), kind);
    return places && with && isIndexType(sparse.indices.componentType) && put(*with, &*places, values);
}

/// Zeros take no bytes of a file, so their number is limited.
constexpr std::size_t kMostZeros = 1 << 24;

} // namespace

std::optional<std::vector<glm::dvec4>> accessorValues(const tinygltf::Model& model, int number)
{
    const tinygltf::Accessor* accessor = entryAt(model.accessors, number);
    if (!accessor) return {};
    const Kind kind = kindOf(*accessor);
    std::vector<glm::dvec4> values;
    if (isOfZeros(model, *accessor))
    {
        if (kind.count > kMostZeros || kind.components > 4) return {};
        values.assign(kind.count, glm::dvec4(0.0, 0.0, 0.0, kind.components < 4 ? 1.0 : 0.0));
    }
    else
    {
        const auto bytes = bytesIn(model, accessor->bufferView, accessor->byteOffset, kind);
        if (!bytes) return {};
        values.assign(bytes->count, glm::dvec4(0.0, 0.0, 0.0, 1.0));
        put(*bytes, nullptr, values);
    }
    if (accessor->sparse.isSparse && !putSparse(model, *accessor, values)) return {};
    return values;
}

std::optional<std::vector<std::uint32_t>> accessorIndices(const tinygltf::Model& model, int number)
{
    const tinygltf::Accessor* accessor = entryAt(model.accessors, number);
    const bool isFit = accessor && kindOf(*accessor).components == 1 && hasData(model, number) &&
                       (accessor->count == 0 || isIndexType(accessor->componentType));
    const auto values = isFit ? accessorValues(model, number) : std::nullopt;
    if (!values) return {};
    std::vector<std::uint32_t> indices(values->size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = static_cast<std::uint32_t>((*values)[i].x);
    return indices;
}

bool hasData(const tinygltf::Model& model, int number)
{
    const tinygltf::Accessor* accessor = entryAt(model.accessors, number);
    return accessor && (accessor->bufferView >= 0 || accessor->sparse.isSparse);
}

} // namespace osgPMObjects::core
