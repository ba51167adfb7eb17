// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

#include <osgMultiTriangulation/core/file/MtInfo.h>

namespace osgMultiTriangulation::core
{

constexpr char kMtMagic[8] = {'o', 's', 'g', 'M', 'T', '\r', '\n', '\x1a'};
constexpr std::uint32_t kMtVersion = 3, kMtOldestVersion = 1; // 1: trees have no sections
constexpr std::uint32_t kMtVersionWithoutReference = 2;
constexpr std::size_t kMtReferenceBytes = 40, kMostMtReferenceText = 1 << 16; // without and of its text
constexpr std::size_t kMtHeaderBytes = 80, kMtEntryBytes = 56;

/// Appends numbers, the lowest byte first.
class LittleEndian
{
public:
    explicit LittleEndian(std::string& bytes) : _bytes(bytes) {}

    template<class T>
    void add(T value)
    {
        using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
        const Bits bits = std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof(T); ++i)
            _bytes.push_back(static_cast<char>(bits >> (8 * i)));
    }

private:
    std::string& _bytes;
};

/// Reads what LittleEndian wrote; the caller has checked the length.
class LittleEndianReader
{
public:
    explicit LittleEndianReader(const char* at) : _at(at) {}

    template<class T>
    void take(T& value)
    {
        using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
        Bits bits = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i)
            bits |= static_cast<Bits>(static_cast<unsigned char>(*_at++)) << (8 * i);
        value = std::bit_cast<T>(bits);
    }

private:
    const char* _at;
};

/// Calls visit(field) for each field of an entry, in the order of the file.
template<class Entry, class Visit>
void visitFields(Entry& entry, const Visit& visit)
{
    visit(entry.offset);
    visit(entry.bytes);
    visit(entry.checksum);
    visit(entry.parent);
    for (int axis = 0; axis < 2; ++axis)
        visit(entry.low[axis]);
    for (int axis = 0; axis < 2; ++axis)
        visit(entry.high[axis]);
    visit(entry.points);
    visit(entry.triangles);
    visit(entry.fragments);
    visit(entry.rootTriangles);
    visit(entry.rootError);
}

std::uint32_t mtChecksum(std::span<const char> bytes);

} // namespace osgMultiTriangulation::core
