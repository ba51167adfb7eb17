// SPDX-License-Identifier: Apache-2.0
#include "PartStore.h"

#include <cstring>
#include <fstream>
#include <type_traits>

#include <foundation/WholeFile.h>
#include <unistd.h>

#include "MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Appends plain values as they lie in memory.
template<class T>
void appendPlain(std::string& bytes, const T& value)
{
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template<class T>
void appendList(std::string& bytes, const std::vector<T>& list)
{
    static_assert(std::is_trivially_copyable_v<T>);
    appendPlain(bytes, static_cast<std::uint64_t>(list.size()));
    bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
}

/// Takes from the front what was appended. Returns whether it was there.
template<class T>
bool takePlain(std::string_view& bytes, T& value)
{
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return true;
}

template<class T>
bool takeList(std::string_view& bytes, std::vector<T>& list)
{
    std::uint64_t count = 0;
    if (!takePlain(bytes, count) || count > bytes.size() / sizeof(T)) return false;
    list.resize(count);
    if (count > 0) std::memcpy(list.data(), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return true;
}

/// Calls visit(list) for each list of a part's rest.
template<class Mesh, class Visit>
void visitLists(Mesh& rest, const Visit& visit)
{
    visit(rest.measured.mesh.points);
    visit(rest.measured.mesh.triangles);
    visit(rest.measured.errors);
    visit(rest.measured.hidden);
    visit(rest.measured.firstHidden);
    visit(rest.inputs);
    visit(rest.joinedAt);
}

} // namespace

PartStore::PartStore(const std::filesystem::path& folder) : _folder(folder)
{
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    _ending = std::string(".") + host + "-" + std::to_string(::getpid()) + ".part";
}

foundation::Result<PartStore> PartStore::existing(const std::filesystem::path& folder, std::uint32_t identity)
{
    PartStore store(folder);
    std::string wanted;
    appendPlain(wanted, identity);
    if (store.get(folder / "build") == wanted) return store;
    return foundation::Error{folder.string(), "is not the folder of this build", "plan the build again"};
}

foundation::Result<PartStore> PartStore::open(const std::filesystem::path& folder, std::uint32_t identity)
{
    if (auto store = existing(folder, identity)) return store;
    PartStore store(folder);
    std::error_code code;
    std::filesystem::remove_all(folder, code);
    std::filesystem::create_directories(folder, code);
    if (code)
        return foundation::Error{folder.string(), "cannot be created: " + code.message(),
                                 "check that its folder exists and is writable"};
    std::string mark;
    appendPlain(mark, identity);
    if (const auto outcome = store.put(folder / "build", mark); !outcome) return outcome.error();
    return store;
}

std::filesystem::path PartStore::nameOf(std::uint32_t part, const char* kind) const
{
    return _folder / (std::to_string(part) + kind);
}

foundation::Outcome PartStore::put(const std::filesystem::path& file, std::string bytes) const
{
    appendPlain(bytes, mtChecksum(bytes));
    return foundation::writeWholeFile(file, bytes, _ending);
}

std::optional<std::string> PartStore::get(const std::filesystem::path& file) const
{
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) return std::nullopt;
    std::string bytes(static_cast<std::size_t>(stream.tellg()), '\0');
    stream.seekg(0);
    std::uint32_t sum = 0;
    if (bytes.size() < sizeof sum || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        return std::nullopt;
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    bytes.resize(bytes.size() - sizeof sum);
    if (mtChecksum(bytes) != sum) return std::nullopt;
    return bytes;
}

foundation::Outcome PartStore::putTree(std::uint32_t part, const StoredTree& tree) const
{
    std::string bytes;
    appendPlain(bytes, tree.locked);
    appendPlain(bytes, tree.encoded.entry);
    appendList(bytes, tree.encoded.bytes);
    return put(nameOf(part, ".tree"), std::move(bytes));
}

std::optional<StoredTree> PartStore::tree(std::uint32_t part) const
{
    const auto bytes = get(nameOf(part, ".tree"));
    if (!bytes) return std::nullopt;
    std::string_view left = *bytes;
    StoredTree tree;
    if (!takePlain(left, tree.locked) || !takePlain(left, tree.encoded.entry) ||
        !takeList(left, tree.encoded.bytes))
        return std::nullopt;
    return tree;
}

foundation::Outcome PartStore::putRest(std::uint32_t part, const PartMesh& rest) const
{
    std::string bytes;
    appendPlain(bytes, rest.allHidden);
    appendPlain(bytes, rest.hiddenSum);
    visitLists(rest, [&](const auto& list) { appendList(bytes, list); });
    return put(nameOf(part, ".rest"), std::move(bytes));
}

std::optional<PartMesh> PartStore::rest(std::uint32_t part) const
{
    const auto bytes = get(nameOf(part, ".rest"));
    if (!bytes) return std::nullopt;
    std::string_view left = *bytes;
    PartMesh rest;
    bool isWhole = takePlain(left, rest.allHidden) && takePlain(left, rest.hiddenSum);
    visitLists(rest, [&](auto& list) { isWhole = isWhole && takeList(left, list); });
    if (!isWhole) return std::nullopt;
    return rest;
}

void PartStore::dropRest(std::uint32_t part) const
{
    std::error_code ignored;
    std::filesystem::remove(nameOf(part, ".rest"), ignored);
    std::filesystem::remove(nameOf(part, ".hidden"), ignored);
}

foundation::Result<RecordFile<HiddenRecord>> PartStore::createHidden(std::uint32_t part) const
{
    return RecordFile<HiddenRecord>::create(nameOf(part, ".hidden") += _ending);
}

foundation::Outcome PartStore::commitHidden(std::uint32_t part) const
{
    const std::filesystem::path file = nameOf(part, ".hidden");
    std::error_code code;
    std::filesystem::rename(std::filesystem::path(file) += _ending, file, code);
    if (!code) return foundation::success();
    return foundation::Error{file.string(), "cannot be put in place: " + code.message(),
                             "check that the folder exists, is writable and has room"};
}

foundation::Result<RecordFile<HiddenRecord>> PartStore::openHidden(std::uint32_t part) const
{
    return RecordFile<HiddenRecord>::open(nameOf(part, ".hidden"));
}

bool PartStore::isHiddenWhole(std::uint32_t part, const PartMesh& rest) const
{
    if (rest.hasAllHidden()) return true;
    const auto file = openHidden(part);
    if (!file || file->size() != rest.allHidden) return false;
    std::uint32_t sum = 0;
    file->scan([&](std::span<const HiddenRecord> run) { sum = sumOfRecords(run, sum); });
    return file->outcome() && sum == rest.hiddenSum;
}

std::uint32_t sumOfRecords(std::span<const HiddenRecord> records, std::uint32_t before)
{
    return before * 31 + mtChecksum({reinterpret_cast<const char*>(records.data()), records.size_bytes()});
}

void PartStore::remove() const
{
    std::error_code ignored;
    std::filesystem::remove_all(_folder, ignored);
}

} // namespace osgMultiTriangulation::core
