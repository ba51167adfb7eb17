// SPDX-License-Identifier: Apache-2.0
// peer_cgal IN.obj FOLDER COUNT…: writes FOLDER/COUNT.obj for each count of faces, simplified by CGAL's edge
// collapse with the cost and placement of Lindstrom and Turk. CGAL's mesh packages are GPL, so this program
// is only for measuring and never installed.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "peers/PlainObj.h"

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace simplification = CGAL::Surface_mesh_simplification;
namespace processing = CGAL::Polygon_mesh_processing;

/// Stops at a number of faces, as the other tools do; CGAL's own predicate counts edges.
struct FaceCountStop
{
    std::size_t most;

    template<class Cost, class Profile>
    bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
    {
        return profile.surface_mesh().number_of_faces() <= most;
    }
};

void write(const SurfaceMesh& mesh, const std::string& file)
{
    std::ofstream stream(file);
    stream.precision(17);
    std::map<SurfaceMesh::Vertex_index, std::size_t> numbers;
    for (const auto v : mesh.vertices())
    {
        numbers.emplace(v, numbers.size() + 1);
        stream << "v " << mesh.point(v) << '\n';
    }
    for (const auto f : mesh.faces())
    {
        stream << 'f';
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
            stream << ' ' << numbers.at(v);
        stream << '\n';
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4)
    {
        std::cerr << "peer_cgal IN.obj FOLDER COUNT...\n";
        return 2;
    }
    peers::PlainMesh plain = peers::readPlainObj(argv[1]);
    std::vector<Kernel::Point_3> points;
    for (const auto& p : plain.positions)
        points.emplace_back(p[0], p[1], p[2]);
    processing::orient_polygon_soup(points, plain.triangles); // splits what is not manifold
    if (!processing::is_polygon_soup_a_polygon_mesh(plain.triangles))
    {
        std::cerr << "CGAL: the faces are no manifold, even with its vertices doubled\n";
        return 1;
    }
    SurfaceMesh original;
    processing::polygon_soup_to_polygon_mesh(points, plain.triangles, original);
    for (int i = 3; i < argc; ++i)
    {
        SurfaceMesh mesh = original;
        const auto start = std::chrono::steady_clock::now();
        simplification::edge_collapse(
            mesh, FaceCountStop{std::strtoul(argv[i], nullptr, 10)},
            CGAL::parameters::get_cost(simplification::LindstromTurk_cost<SurfaceMesh>())
                .get_placement(simplification::LindstromTurk_placement<SurfaceMesh>()));
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        mesh.collect_garbage();
        write(mesh, std::string(argv[2]) + '/' + argv[i] + ".obj");
        std::cout << argv[i] << ' ' << took.count() << '\n';
    }
    return 0;
}
