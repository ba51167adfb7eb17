// SPDX-License-Identifier: Apache-2.0
#include "Compositions.h"

#include <iterator>
#include <regex>
#include <set>

namespace shadercheck
{

namespace
{

std::set<std::string> importedDefines(const std::string& text)
{
    static const std::regex kPragma(R"(#pragma import_defines \(([^)]*)\))"), kName(R"(\w+)");
    std::set<std::string> names;
    std::smatch found;
    if (!std::regex_search(text, found, kPragma)) return names;
    const std::string list = found[1];
    for (std::sregex_iterator name(list.begin(), list.end(), kName); name != std::sregex_iterator(); ++name)
        names.insert(name->str());
    return names;
}

/// Those of the defines that the text imports, behind its #version line.
std::string withDefines(const std::string& text, const std::set<std::string>& defines)
{
    std::string lines;
    for (const std::string& name : importedDefines(text))
        if (defines.contains(name)) lines += "#define " + name + "\n";
    return std::string(text).insert(text.find('\n', text.find("#version")) + 1, lines);
}

std::string stageOf(const osg::Shader& shader)
{
    return shader.getType() == osg::Shader::VERTEX ? "vert" : "frag";
}

} // namespace

namespace
{

constexpr const char* kWeather = "SURFACE_WEATHER";

/// One with water and snow, where the program knows of them. Whether it is sound is asked where stages are
/// linked.
void addWeathered(const NamedProgram& named, std::vector<std::vector<Composition>>& variants)
{
    const std::string kDefine = kWeather;
    std::vector<Composition> shaders;
    bool knows = false;
    for (unsigned i = 0; i < named.program->getNumShaders(); ++i)
    {
        const osg::Shader& shader = *named.program->getShader(i);
        std::string text = shader.getShaderSource();
        knows = knows || text.find("#ifdef " + kDefine) != std::string::npos;
        text.insert(text.find('\n', text.find("#version")) + 1, "#define " + kDefine + "\n");
        shaders.push_back({named.name + " " + kDefine, stageOf(shader), text});
    }
    if (knows) variants.push_back(std::move(shaders));
}

} // namespace

std::vector<std::vector<Composition>> variantsOf(const NamedProgram& named)
{
    std::vector<std::string> names;
    std::set<std::string> all;
    for (unsigned i = 0; i < named.program->getNumShaders(); ++i)
        all.merge(importedDefines(named.program->getShader(i)->getShaderSource()));
    names.assign(all.begin(), all.end());

    std::vector<std::vector<Composition>> variants;
    for (unsigned mask = 0; mask < 1u << names.size(); ++mask)
    {
        std::set<std::string> defines;
        std::string title = named.name;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (mask >> i & 1u)
            {
                defines.insert(names[i]);
                title += " " + names[i];
            }
        std::vector<Composition>& shaders = variants.emplace_back();
        for (unsigned i = 0; i < named.program->getNumShaders(); ++i)
        {
            const osg::Shader& shader = *named.program->getShader(i);
            shaders.push_back({title, stageOf(shader), withDefines(shader.getShaderSource(), defines)});
        }
    }
    addWeathered(named, variants);
    return variants;
}

std::vector<Composition> compositionsOf(const std::vector<NamedProgram>& programs)
{
    std::set<std::string> seen;
    std::vector<Composition> compositions;
    for (const NamedProgram& named : programs)
        for (const auto& shaders : variantsOf(named))
            for (const Composition& composition : shaders)
                if (!composition.name.ends_with(kWeather) &&
                    seen.insert(composition.stage + composition.text).second)
                    compositions.push_back(composition);
    return compositions;
}

} // namespace shadercheck
