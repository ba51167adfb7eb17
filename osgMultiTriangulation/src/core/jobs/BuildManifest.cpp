// SPDX-License-Identifier: Apache-2.0
#include "BuildManifest.h"

#include <charconv>
#include <sstream>
#include <type_traits>

#include <foundation/WholeText.h>

#include "../file/MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr const char* kFirstLine = "osgMT jobs 2";
constexpr std::uint32_t kMostJobs = 1u << 24;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 31;

/// Appends words to lines; doubles exactly, in hexadecimal.
class ManifestWriter
{
public:
    void add(const std::string& word) { _text += word + " "; }
    void add(std::uint64_t value) { add(std::to_string(value)); }
    void add(double value)
    {
        char digits[64];
        const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::hex).ptr;
        add(std::string(digits, end));
    }
    void endLine() { _text.back() = '\n'; }
    const std::string& text() const { return _text; }

private:
    std::string _text;
};

/// Takes words from a text; after the first that is not what was asked for, isWhole() is false.
class ManifestReader
{
public:
    explicit ManifestReader(const std::string& text) : _words(text) {}

    void expect(const std::string& wanted) { _isWhole = next() == wanted && _isWhole; }

    template<class T>
    T take()
    {
        const std::string word = next();
        T value{};
        std::from_chars_result read{};
        if constexpr (std::is_floating_point_v<T>)
            read = std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::hex);
        else
            read = std::from_chars(word.data(), word.data() + word.size(), value);
        _isWhole =
            _isWhole && !word.empty() && read.ec == std::errc{} && read.ptr == word.data() + word.size();
        return value;
    }

    std::string next()
    {
        std::string word;
        _words >> word;
        return word;
    }

    void fail() { _isWhole = false; }
    bool isWhole() const { return _isWhole; }

private:
    std::istringstream _words;
    bool _isWhole = true;
};

/// Adds the place of the plan in a reference system, whose text may have anything in it, as numbers of bytes.
void addReference(ManifestWriter& out, const PlanFrame& frame)
{
    out.add("references");
    out.add(std::uint64_t{frame.reference ? 1u : 0u});
    if (frame.reference)
    {
        const PlanReference& at = *frame.reference;
        for (const double value : {at.firstX, at.firstY, at.stepX, at.stepY})
            out.add(value);
        out.add(std::uint64_t{at.system.size()});
        for (const char letter : at.system)
            out.add(std::uint64_t{static_cast<unsigned char>(letter)});
    }
    out.endLine();
}

void takeReference(ManifestReader& in, PlanFrame& frame)
{
    in.expect("references");
    if (in.take<std::uint32_t>() == 0) return;
    PlanReference at;
    for (double* value : {&at.firstX, &at.firstY, &at.stepX, &at.stepY})
        *value = in.take<double>();
    const auto length = in.take<std::uint32_t>();
    if (length > kMostMtReferenceText) return in.fail();
    for (std::uint32_t i = 0; i < length && in.isWhole(); ++i)
        at.system += static_cast<char>(in.take<std::uint8_t>());
    frame.reference = std::move(at);
}

void addJob(ManifestWriter& out, const BuildManifest& manifest, const JobOrder& order, std::uint32_t job)
{
    const std::uint32_t p = order.partOf[job];
    const PlanPart& part = manifest.partition.parts[p];
    out.add("job");
    out.add(std::uint64_t{job});
    out.add("part");
    out.add(std::uint64_t{p});
    out.add("points");
    out.add(std::uint64_t{part.points});
    out.add("triangles");
    out.add(manifest.trianglesOf[p]);
    out.add(part.isWhole() ? "rectangle" : "after");
    if (!part.isWhole())
    {
        for (const std::uint32_t half : part.halves)
            out.add(std::uint64_t{order.jobOf[half]});
        out.add("cut");
        out.add(std::uint64_t{part.axis});
        out.add(part.cut);
    }
    out.endLine();
}

/// Reads the lines of jobs. The jobs that one needs stand before it.
void takeJobs(ManifestReader& in, BuildManifest& manifest)
{
    const auto count = in.take<std::uint32_t>();
    if (!in.isWhole() || count == 0 || count > kMostJobs) return in.fail();
    std::vector<PlanPart>& parts = manifest.partition.parts;
    parts.resize(count);
    manifest.trianglesOf.resize(count);
    std::vector<std::uint32_t> partOf;
    for (std::uint32_t job = 0; job < count && in.isWhole(); ++job)
    {
        in.expect("job");
        in.expect(std::to_string(job));
        in.expect("part");
        const auto number = in.take<std::uint32_t>();
        if (number >= count) return in.fail();
        PlanPart& part = parts[number];
        in.expect("points");
        part.points = in.take<std::uint32_t>();
        in.expect("triangles");
        manifest.trianglesOf[number] = in.take<std::uint64_t>();
        if (in.next() == "after")
        {
            for (std::uint32_t& half : part.halves)
            {
                const auto before = in.take<std::uint32_t>();
                if (before >= job) return in.fail();
                half = partOf[before];
                if (half <= number || parts[half].parent != kNone) return in.fail();
                parts[half].parent = number;
            }
            in.expect("cut");
            part.axis = in.take<std::uint32_t>() & 1;
            part.cut = in.take<double>();
        }
        else
            ++manifest.partition.rectangles;
        partOf.push_back(number);
    }
    for (std::uint32_t p = 1; p < count && in.isWhole(); ++p)
    {
        if (parts[p].parent == kNone) return in.fail();
        parts[p].depth = parts[parts[p].parent].depth + 1;
    }
}

} // namespace

std::string textOf(const BuildManifest& manifest)
{
    ManifestWriter out;
    out.add(kFirstLine);
    out.endLine();
    out.add("surface");
    out.add(manifest.points);
    out.add(manifest.triangles);
    for (const double value : {manifest.frame.originX, manifest.frame.originY, manifest.frame.stepX,
                               manifest.frame.stepY, manifest.heightStep})
        out.add(value);
    out.add(manifest.mostHidden);
    out.add(std::uint64_t{manifest.identity});
    out.endLine();
    addReference(out, manifest.frame);
    const JobOrder order = jobOrder(manifest.partition);
    out.add("jobs");
    out.add(std::uint64_t{order.partOf.size()});
    out.endLine();
    for (std::uint32_t job = 0; job < order.partOf.size(); ++job)
        addJob(out, manifest, order, job);
    const std::uint64_t sum = mtChecksum(out.text());
    out.add("sum");
    out.add(sum);
    out.endLine();
    return out.text();
}

foundation::Result<BuildManifest> readManifest(const std::filesystem::path& file)
{
    const auto read = foundation::readWholeText(file, kMostBytes);
    if (!read) return read.error();
    ManifestReader in(*read);
    BuildManifest manifest;
    for (const char* word : {"osgMT", "jobs", "2", "surface"})
        in.expect(word);
    manifest.points = in.take<std::uint64_t>();
    manifest.triangles = in.take<std::uint64_t>();
    for (double* value : {&manifest.frame.originX, &manifest.frame.originY, &manifest.frame.stepX,
                          &manifest.frame.stepY, &manifest.heightStep})
        *value = in.take<double>();
    manifest.mostHidden = in.take<std::uint64_t>();
    manifest.identity = in.take<std::uint32_t>();
    takeReference(in, manifest.frame);
    in.expect("jobs");
    takeJobs(in, manifest);
    if (in.isWhole() && textOf(manifest) == *read) return manifest; // with the sum
    return foundation::Error{file.string(), "is damaged, or of another version", "plan the build again"};
}

} // namespace osgMultiTriangulation::core
