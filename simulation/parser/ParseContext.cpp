// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ParseContext.h"

#include "simulation/parser/ElementReader.h"
#include "simulation/parser/Expression.h"
#include "simulation/parser/Keywords.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMaximumProblems = 1000;

bool satisfies(const std::string& value, Rule rule, const std::string& bound)
{
    const std::optional<double> left = parseNumber(value);
    const std::optional<double> right = parseNumber(bound);
    if (!left || !right)
    {
        if (rule == Rule::equalTo) return value == bound;
        return rule == Rule::notEqualTo && value != bound;
    }
    return holds(*left, rule, *right);
}

} // namespace

ParseContext::ParseContext(const ParseOptions& optionsIn, const XmlSource& source, CatalogShelf& shelfIn)
    : options(optionsIn), shelf(shelfIn), _source(&source), _scopes(1)
{
}

void ParseContext::unsupported(pugi::xml_node node, const std::string& what)
{
    // A tolerant reading is what the check does: it must not recommend itself.
    const std::string remedy =
        options.tolerant ? "remove it" : "remove it, or see what `trainer check` lists";
    add({Problem::Kind::unsupported, {place(node), what + " is not supported yet", remedy}});
}

void ParseContext::invalid(pugi::xml_node node, const std::string& what, const std::string& remedy)
{
    add({Problem::Kind::invalid, {place(node), what, remedy}});
}

void ParseContext::add(Problem problem)
{
    if (!isStopped() && problems.size() < kMaximumProblems) problems.push_back(std::move(problem));
}

std::string ParseContext::place(pugi::xml_node node) const
{
    return _source->name() + ":" + std::to_string(_source->lineOf(node));
}

std::optional<std::string> ParseContext::lookup(std::string_view name) const
{
    for (auto scope = _scopes.rbegin(); scope != _scopes.rend(); ++scope)
        if (const auto found = scope->find(name); found != scope->end()) return found->second;
    return std::nullopt;
}

std::vector<ParameterDeclaration> ParseContext::declareParameters(pugi::xml_node parent, const Scope& given)
{
    std::vector<ParameterDeclaration> declarations;
    for (pugi::xml_node node : parent.child("ParameterDeclarations").children())
    {
        ElementReader reader(*this, node);
        if (!reader.is("ParameterDeclaration")) continue;
        reader.allowChildren({"ConstraintGroup"});
        ParameterDeclaration declaration{line(node), reader.text("name"), reader.text("parameterType"), ""};
        if (!declaration.name.empty() && declaration.name.front() == '$') declaration.name.erase(0, 1);
        const auto replaced = given.find(declaration.name);
        declaration.value = replaced == given.end() ? reader.text("value") : replaced->second;
        checkConstraints(node, declaration.value);
        _scopes.back()[declaration.name] = declaration.value;
        declarations.push_back(std::move(declaration));
    }
    return declarations;
}

/// A value must meet every constraint of at least one group.
void ParseContext::checkConstraints(pugi::xml_node declaration, const std::string& value)
{
    bool anyGroup = false;
    for (pugi::xml_node group : declaration.children("ConstraintGroup"))
    {
        anyGroup = true;
        bool all = true;
        for (pugi::xml_node node : group.children("ValueConstraint"))
        {
            ElementReader reader(*this, node);
            const Rule rule = reader.choice("rule", kRules);
            all = all && satisfies(value, rule, reader.text("value"));
        }
        if (all) return;
    }
    if (anyGroup)
        invalid(declaration, "the value " + value + " breaks the parameter's constraints", "change it");
}

} // namespace simulation
