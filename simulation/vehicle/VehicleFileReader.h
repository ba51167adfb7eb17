// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <foundation/Result.h>
#include <foundation/XmlSource.h>
#include <glm/glm.hpp>

#include "simulation/vehicle/Table.h"

namespace simulation
{

/// Reads the elements of a vehicle's data file and keeps the first error; what is read after an error is 0.
class VehicleFileReader
{
public:
    /// `page`: of the documentation, for remedies; a text that lives as long as the program.
    VehicleFileReader(const foundation::XmlSource& source, std::string_view page)
        : _source(source), _page(page)
    {
    }

    const std::optional<foundation::Error>& error() const { return _error; }

    /// Keeps an error at an element, unless there is one already.
    void fail(pugi::xml_node node, const std::string& what, std::string remedy);

    /// A number of an attribute, from `least` to `most`.
    double number(pugi::xml_node node, const char* attribute, double least, double most);

    /// The attributes xM, yM, zM.
    glm::dvec3 place(pugi::xml_node node);

    /// A table in an element's text: rows of numbers, the first its argument. `hasColumns`: the first row has
    /// the columns' arguments. A single number is a constant.
    Table table(pugi::xml_node node, bool hasColumns);

    std::string name(pugi::xml_node node);

    /// The only child of that name; an error where there is none.
    pugi::xml_node child(pugi::xml_node parent, const char* name);

    /// Fails where an element of the file is none of these (separated by blanks) or names no listed source;
    /// lists sources first.
    void onlyElements(pugi::xml_node root, std::string_view names);

    /// Fails where an element has attributes other than these (separated by blanks) and name and source.
    void onlyAttributes(pugi::xml_node node, std::string_view names);

private:
    void listSource(pugi::xml_node node);
    void checkSource(pugi::xml_node node);
    /// The remedy for an unknown name among those that there are.
    std::string lists(std::string_view misspelt, std::string_view names) const;

    const foundation::XmlSource& _source;
    std::string_view _page;
    std::set<std::string> _sources;
    std::optional<foundation::Error> _error;
};

} // namespace simulation
