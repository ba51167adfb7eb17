// SPDX-License-Identifier: Apache-2.0
// Models are read in a child process, so that whatever happens there is an error here.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include <osgPMObjects/ReadModel>

#include "GltfText.h"
#include "RealData.h"
#include "read/ContainedRun.h"

namespace
{

using namespace osgPMObjects;

class Scratch
{
public:
    Scratch()
        : _folder(std::filesystem::temp_directory_path() / ("read_model_test_" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(_folder);
    }
    ~Scratch() { std::filesystem::remove_all(_folder); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(_folder / name, std::ios::binary) << bytes;
        return _folder / name;
    }

private:
    std::filesystem::path _folder;
};

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

std::string errorOf(const std::function<foundation::Result<std::string>()>& work,
                    const ReadLimits& limits = {})
{
    const auto made = runContained(work, "model.ac", "the loader", limits);
    return made ? "none" : made.error().message();
}

TEST(ContainedRun, HandsOverWhatWasMade)
{
    const std::string large(5000000, 'x');
    const auto made = runContained([&] { return foundation::Result<std::string>(large); }, "a", "b", {});
    ASSERT_TRUE(made);
    EXPECT_EQ(*made, large);
    EXPECT_EQ(errorOf(
                  [] {
                      return foundation::Result<std::string>(foundation::Error{"x", "no", "mend it"});
                  }),
              "model.ac: no; mend it");
}

TEST(ContainedRun, ACrashIsAnError)
{
    const auto dies = [](int signal)
    {
        return errorOf(
            [signal]() -> foundation::Result<std::string>
            {
                raise(signal);
                return std::string();
            });
    };
    EXPECT_EQ(dies(SIGSEGV).find("model.ac: the loader died of Segmentation fault; repair"), 0u)
        << dies(SIGSEGV);
    EXPECT_NE(dies(SIGABRT).find("died of Aborted"), std::string::npos);
    EXPECT_NE(errorOf([]() -> foundation::Result<std::string> { _exit(3); }).find("ended itself"),
              std::string::npos);
    EXPECT_NE(errorOf([]() -> foundation::Result<std::string> { throw std::runtime_error("thrown"); })
                  .find("thrown"),
              std::string::npos);
}

TEST(ContainedRun, AHangIsAnErrorAfterItsTime)
{
    const auto start = std::chrono::steady_clock::now();
    const std::string error = errorOf(
        []() -> foundation::Result<std::string>
        {
            while (true)
                std::this_thread::sleep_for(std::chrono::seconds(1));
        },
        {.seconds = 0.5});
    EXPECT_NE(error.find("was not done after"), std::string::npos) << error;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ContainedRun, EatingAllMemoryIsAnError)
{
    const std::string error =
        errorOf([]() -> foundation::Result<std::string> { return std::string(3000u << 20, 'x'); },
                {.memoryMiB = 2048});
    EXPECT_NE(error.find("wanted more than 2048 MiB; allow it more"), std::string::npos) << error;
}
#endif

TEST(ReadModel, ReadsThroughTheChildWhatItReadsHere)
{
    const Scratch scratch;
    for (const auto& file :
         {scratch.write("square.obj", kSquare), scratch.write("tri.gltf", testsupport::gltfText())})
    {
        const auto here = readModelNodeHere(file), there = readModelNode(file);
        ASSERT_TRUE(here) << here.error().message();
        ASSERT_TRUE(there) << there.error().message();
        const auto a = importNode(**here, "a"), b = importNode(**there, "b");
        ASSERT_TRUE(a && b);
        EXPECT_GT(a->mesh.faces.size(), 0u);
        EXPECT_EQ(a->mesh.positions, b->mesh.positions);
        EXPECT_EQ(a->mesh.faces, b->mesh.faces);
        EXPECT_EQ(a->mesh.normals, b->mesh.normals);
        EXPECT_EQ(a->mesh.materials, b->mesh.materials);
    }
}

/// A low pyramid without normals, each of its sides so many times.
std::string pyramidText(int times)
{
    std::string text = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 .5\n";
    for (int i = 0; i < times; ++i)
        text += "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    return text;
}

bool hasOneNormalAFace(const core::Mesh& mesh)
{
    return std::all_of(mesh.faces.begin(), mesh.faces.end(),
                       [&](const core::Face& face)
                       {
                           const glm::vec3& first = mesh.normals[face.wedges[0]];
                           return mesh.normals[face.wedges[1]] == first &&
                                  mesh.normals[face.wedges[2]] == first;
                       });
}

/// OSG's loader takes time by the square of the faces at a vertex to smooth them: minutes for a file of 2 MB.
TEST(ReadModel, LetsNoNormalsBeSmoothedAmongCrowdedFaces)
{
    const Scratch scratch;
    const auto read = [&](int times)
    { return readModelNode(scratch.write("pyramid.obj", pyramidText(times))); };
    const auto few = read(1), many = read(50);
    ASSERT_TRUE(few && many);
    const auto usual = importNode(**few, "few"), crowded = importNode(**many, "many");
    ASSERT_TRUE(usual && crowded);
    EXPECT_EQ(crowded->mesh.faces.size(), 200u);
    EXPECT_TRUE(hasOneNormalAFace(crowded->mesh));
    EXPECT_FALSE(hasOneNormalAFace(usual->mesh)); // the control
}

TEST(ReadModel, SaysWhatIsWrongWithAFile)
{
    const Scratch scratch;
    const auto messageFor = [](const std::filesystem::path& file)
    {
        const auto node = readModelNode(file);
        return node ? "read" : node.error().message();
    };
    EXPECT_NE(messageFor("/nowhere/a.obj").find("/nowhere/a.obj: there is no such file"), std::string::npos);
    const auto unknown = scratch.write("a.strange", "what");
    EXPECT_EQ(messageFor(unknown).find(unknown.string() + ": cannot be read by OpenSceneGraph"), 0u);
    const auto damaged = scratch.write("a.glb", "glTF\2");
    EXPECT_EQ(messageFor(damaged).find(damaged.string() + ": cannot be read as glTF 2"), 0u)
        << messageFor(damaged);
}

/// Real models of every format with changed bytes: loaders may crash in the child process, but nothing in
/// this one may. OSGTRAINER_MUTATIONS: their total number (84).
TEST(ReadModel, MutatedRealModelsCrashNothingOfOurs)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(models, "models");
    const char* asked = std::getenv("OSGTRAINER_MUTATIONS");
    const int count = asked ? std::atoi(asked) : 84;
    const char* files[] = {"vehicle/110Bus.ac",      "vehicle/hoskosh-ti-1500.ac", "vehicle/fox_wrc.obj",
                           "character/spider.obj",   "cad/2CylinderEngine.glb",    "ship/CG-57.ac.gz",
                           "vehicle/ICE3firstcar.ac"};
    const Scratch scratch;
    int readable = 0, refused = 0, died = 0;
    for (int i = 0; i < count; ++i)
    {
        const std::filesystem::path file = models / files[static_cast<std::size_t>(i) % std::size(files)];
        std::ifstream stream(file, std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        std::mt19937 random(static_cast<unsigned>(i));
        const std::size_t reach = i % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 4096);
        for (unsigned n = 1 + random() % 24; n > 0; --n)
            bytes[random() % reach] = static_cast<char>(random() % 2 ? '0' + random() % 10 : random() % 256);
        if (i % 11 == 10) bytes.resize(random() % bytes.size());
        const auto mutated = scratch.write("m" + std::to_string(i) + file.filename().string(), bytes);
        const auto node = readModelNode(mutated, {.seconds = 60.0, .memoryMiB = 4096});
        std::filesystem::remove(mutated);
        if (!node)
        {
            ++(node.error().what.find(" died of ") != std::string::npos ||
                       node.error().what.find("ended itself") != std::string::npos
                   ? died
                   : refused);
            EXPECT_EQ(node.error().place, mutated.string());
            continue;
        }
        auto model = importNode(**node, "mutated");
        if (!model) continue;
        ++readable;
        ASSERT_EQ(core::defectOf(model->mesh), "") << i;
        if (model->mesh.faces.size() > 50000 && i % 5 != 0) continue; // saves time
        core::consolidate(model->mesh);
        ASSERT_EQ(core::defectOf(model->mesh), "") << i;
    }
    std::cout << count << " mutated models: " << readable << " read, " << refused << " refused, in " << died
              << " the loader died\n";
    EXPECT_GT(readable, 0);
}

} // namespace
