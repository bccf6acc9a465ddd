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
    for (std::string name : {"points-8", "points-97336", "points-1000000"}) {
        const auto list = read_doubles(std::string(arguments[1]) + "/" + name);
        const double side = list[0];
        const Triangulation::Iso_cuboid domain(0, 0, 0, side, side, side);
        std::vector<Triangulation::Point> points;
        for (size_t i = 1; i + 2 < list.size(); i += 3) points.emplace_back(list[i], list[i + 1], list[i + 2]);
        const double start = processor_seconds();
        Triangulation triangulation(domain);
        triangulation.insert(points.begin(), points.end(), points.size() > 1000);
        const double time = processor_seconds() - start;
        const auto cells = triangulation.number_of_cells();
        const bool is_small = points.size() < 1000;
        const double value = is_small ? time * 1e3 : time;
        print("CGAL periodic Delaunay", name, points.size(), cells, value, is_small ? "ms" : "s");
        if (is_small) continue;
        const double begin = processor_seconds();
        const bool valid = triangulation.is_valid();
        const double check = processor_seconds() - begin;
        print("CGAL is_valid", name, points.size(), valid ? cells : 0, check, "s");
    }
}
