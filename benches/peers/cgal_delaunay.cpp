// CGAL: periodic Delaunay triangulations in a cube, and their is_valid.
//   cgal_delaunay DIRECTORY
#include "acute.hpp"
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;

int main(int, char **arguments) {
    using clock = std::chrono::steady_clock;
    for (std::string name : {"points-8", "points-97336", "points-1000000"}) {
        const auto list = read_doubles(std::string(arguments[1]) + "/" + name);
        const double side = list[0];
        const Triangulation::Iso_cuboid domain(0, 0, 0, side, side, side);
        std::vector<Triangulation::Point> points;
        for (size_t i = 1; i + 2 < list.size(); i += 3) points.emplace_back(list[i], list[i + 1], list[i + 2]);
        const auto start = clock::now();
        Triangulation triangulation(domain);
        triangulation.insert(points.begin(), points.end(), points.size() > 1000);
        const std::chrono::duration<double> time = clock::now() - start;
        const auto cells = triangulation.number_of_cells();
        const bool is_small = points.size() < 1000;
        const double value = is_small ? time.count() * 1e3 : time.count();
        print("CGAL periodic Delaunay", name, points.size(), cells, value, is_small ? "ms" : "s");
        if (is_small) continue;
        const auto begin = clock::now();
        const bool valid = triangulation.is_valid();
        const std::chrono::duration<double> check = clock::now() - begin;
        print("CGAL is_valid", name, points.size(), valid ? cells : 0, check.count(), "s");
    }
}
