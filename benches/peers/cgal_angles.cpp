// CGAL: dihedral angles compared with 90 degrees by the filtered exact kernel, and the test over
// Sqrt_extension and CORE::Expr.
//   cgal_angles DIRECTORY
#include "acute.hpp"
#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Sqrt_extension.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Root = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>;

static bool is_acute_cgal(const std::array<Kernel::Point_3, 4> &p) {
    static const auto compare = Kernel().compare_dihedral_angle_3_object();
    if (CGAL::orientation(p[0], p[1], p[2], p[3]) != CGAL::POSITIVE) return false;
    const int edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
    for (const auto &e : edges)
        if (compare(p[e[0]], p[e[1]], p[e[2]], p[e[3]], Kernel::FT(0)) != CGAL::SMALLER) return false;
    return true;
}

static void kernel(const std::string &folder, const std::string &name) {
    const auto all = read_corners(folder + name);
    std::vector<std::array<Kernel::Point_3, 4>> points(all.size());
    for (size_t i = 0; i < all.size(); i++)
        for (int k = 0; k < 4; k++) points[i][k] = {all[i][k][0], all[i][k][1], all[i][k][2]};
    size_t naive_count, count;
    const double naive = count_acute(all, naive_count);
    print("doubles in C++, no proof", name, all.size(), naive_count, naive, "ns each");
    const double each = fastest([&] {
        count = 0;
        for (const auto &p : points) count += is_acute_cgal(p);
    }) * 1e9 / all.size();
    print("CGAL dihedral predicate", name, all.size(), count, each, "ns each");
}

// Expressions of CORE remember what was computed, so that they are made anew in each run by
// `corner(i, k)`, coordinate k of tetrahedron i.
template <class T, class F> static void field(const char *program, const char *name, size_t items, F corner) {
    std::vector<Corners<T>> all(items);
    size_t count = 0;
    double least = 1e300;
    for (int round = 0; round < 3; round++) {
        for (size_t i = 0; i < items; i++)
            for (int k = 0; k < 12; k++) all[i][k / 3][k % 3] = corner(i, k);
        const double start = processor_seconds();
        count = 0;
        for (const auto &corners : all) count += is_acute(corners);
        least = std::min(least, processor_seconds() - start);
    }
    print(program, name, items, count, least * 1e9 / items, "ns each");
}

int main(int, char **arguments) {
    const std::string folder = std::string(arguments[1]) + "/";
    for (const char *name : {"easy", "mixed", "right"}) kernel(folder, name);
    const Exact exact = read_exact(folder + "degree-2", 1 << 20);
    const auto rational = [](const std::string &text) { return CGAL::Gmpq(text); };
    field<Root>("CGAL Sqrt_extension", "degree-2", exact.rows.size(), [&](size_t i, int k) {
        const auto &t = exact.rows[i][k];
        return t.size() < 2 ? Root(rational(t[0])) : Root(rational(t[0]), rational(t[1]), CGAL::Gmpq(5));
    });
    const CORE::Expr root = CORE::sqrt(CORE::Expr(5));
    const auto expression = [](const std::string &text) { return CORE::Expr(CORE::BigRat(text.c_str())); };
    field<CORE::Expr>("CORE Expr", "degree-2", 300, [&](size_t i, int k) {
        const auto &t = exact.rows[i][k];
        return t.size() < 2 ? expression(t[0]) : expression(t[0]) + expression(t[1]) * root;
    });
    const auto right = read_corners(folder + "right");
    field<CORE::Expr>("CORE Expr", "right", 300, [&](size_t i, int k) { return CORE::Expr(right[i][k / 3][k % 3]); });
}
