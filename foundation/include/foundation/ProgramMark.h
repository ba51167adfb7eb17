// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <string_view>

#include <elf.h>
#include <foundation/ContentMark.h>
#include <link.h>

namespace foundation
{

/// Reads the marks that the linker gave to the program and its libraries.
class ProgramMark
{
public:
    /// Returns a mark of the running program and of the libraries that it is linked with (plugins of osgDB do
    /// not count), by their build-ids: any other code has another one. Absent where the program has no
    /// build-id. Source: System V ABI, *Note Section*; the note NT_GNU_BUILD_ID.
    static std::optional<ContentMark> ofThis()
    {
        ProgramMark found;
        dl_iterate_phdr(&visit, &found);
        return found._hasProgram ? std::optional(found._mark) : std::nullopt;
    }

private:
    static int visit(dl_phdr_info* object, std::size_t, void* to)
    {
        auto& found = *static_cast<ProgramMark*>(to);
        const std::string_view name(object->dlpi_name);
        if (name.find("osgPlugins") != std::string_view::npos) return 0;
        for (std::size_t i = 0; i < object->dlpi_phnum; ++i)
            if (const auto& part = object->dlpi_phdr[i]; part.p_type == PT_NOTE)
                found.addNotes(
                    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader tells addresses as integers
                    {reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr), part.p_memsz},
                    part.p_align == 8 ? 8 : 4, name.empty());
        return 0;
    }

    void addNotes(std::string_view notes, std::size_t alignment, bool isProgram)
    {
        const auto padded = [&](std::size_t size) { return (size + alignment - 1) / alignment * alignment; };
        ElfW(Nhdr) head;
        while (notes.size() > sizeof head)
        {
            std::memcpy(&head, notes.data(), sizeof head);
            const std::size_t bytesAt = padded(sizeof head + head.n_namesz), end = bytesAt + head.n_descsz;
            if (end > notes.size()) return;
            const bool isGnu = notes.substr(sizeof head, head.n_namesz) == std::string_view("GNU\0", 4);
            if (isGnu && head.n_type == NT_GNU_BUILD_ID)
            {
                _mark.add(notes.substr(bytesAt, head.n_descsz));
                _hasProgram = _hasProgram || isProgram;
            }
            if (padded(end) >= notes.size()) return;
            notes.remove_prefix(padded(end));
        }
    }

    ContentMark _mark;
    bool _hasProgram = false;
};

} // namespace foundation
