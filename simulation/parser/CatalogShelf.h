// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "simulation/parser/ElementReader.h"
#include "simulation/parser/ParseContext.h"
#include "simulation/parser/XmlSource.h"

namespace simulation
{

/// The catalogues of a scenario: the regular .xosc files directly in the folders that CatalogLocations names,
/// and files that it names themselves. The files of a folder are sorted by name, and each is read once.
class CatalogShelf
{
public:
    /// `folder`: the folder of the scenario; absent for a text in memory, which has no catalogues.
    explicit CatalogShelf(std::optional<std::filesystem::path> folder) : _folder(std::move(folder)) {}

    /// Reads the files in the folders of a CatalogLocations element.
    void open(ParseContext& context, pugi::xml_node locations);

    struct Entry
    {
        const XmlSource* source = nullptr;
        pugi::xml_node node;
    };

    /// Finds an entry of a catalogue, which is named by its own name or by the name of its file; empty when
    /// there is none.
    Entry find(const std::string& catalog, const std::string& entry) const;

private:
    void openDirectory(ParseContext& context, pugi::xml_node directory, const std::filesystem::path& path);
    void openFile(ParseContext& context, const std::filesystem::path& file);

    std::optional<std::filesystem::path> _folder;
    std::set<std::filesystem::path> _opened;
    std::vector<std::unique_ptr<XmlSource>> _sources;
};

/// The scope of a catalogue entry. While it lives, the context has the file of the entry, and finds the
/// parameters of the entry before those of the scenario. (The standard hides the latter; files in use count
/// on them.)
class CatalogVisit
{
public:
    /// `reference`: a CatalogReference element. A missing entry or a cycle becomes a problem, and entry() is
    /// then empty. `instead`: what is done without the entry; null: nothing can be.
    explicit CatalogVisit(ElementReader reference, const char* instead = nullptr);
    ~CatalogVisit();
    CatalogVisit(const CatalogVisit&) = delete;
    CatalogVisit& operator=(const CatalogVisit&) = delete;

    pugi::xml_node entry() const { return _entry; }

private:
    ParseContext& _context;
    const XmlSource* _outerSource;
    pugi::xml_node _outerEntry;
    pugi::xml_node _entry;
};

} // namespace simulation
