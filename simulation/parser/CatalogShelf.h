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

/// The catalogue files of a scenario: regular .xosc files directly in the folders that CatalogLocations
/// names, taken in the order of their names, each read once.
class CatalogShelf
{
public:
    /// `folder`: where the scenario lies; absent for a text in memory, which has no catalogues.
    explicit CatalogShelf(std::optional<std::filesystem::path> folder) : _folder(std::move(folder)) {}

    /// Notes the folders of a CatalogLocations element and reads their files.
    void open(ParseContext& context, pugi::xml_node locations);

    struct Entry
    {
        const XmlSource* source = nullptr;
        pugi::xml_node node;
    };

    /// The entry of a catalogue, which goes by its own name or by that of its file; empty when there is none.
    Entry find(const std::string& catalog, const std::string& entry) const;

private:
    void openDirectory(ParseContext& context, pugi::xml_node directory, const std::filesystem::path& path);

    std::optional<std::filesystem::path> _folder;
    std::set<std::filesystem::path> _opened;
    std::vector<std::unique_ptr<XmlSource>> _sources;
};

/// Reading inside a catalogue entry: while it lives, the context sees the entry's file, and the entry's parameters
/// before those of the scenario (which the language would hide, but files in use count on).
class CatalogVisit
{
public:
    /// `reference`: a CatalogReference element. A missing entry or a cycle is a problem, and entry() is
    /// empty.
    explicit CatalogVisit(ElementReader reference);
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
