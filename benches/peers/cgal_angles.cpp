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

template <class T, class F> static void field(const char *program, const std::string &folder, size_t most, F number) {
    const std::string name = "degree-2";
    const Exact exact = read_exact(folder + name, most);
    std::vector<Corners<T>> all(exact.rows.size());
    size_t count = 0;
    // Expressions of CORE remember what was computed, so that they are made anew in each run.
    double least = 1e300;
    for (int round = 0; round < 3; round++) {
        for (size_t i = 0; i < all.size(); i++)
            for (int k = 0; k < 12; k++) all[i][k / 3][k % 3] = number(exact.rows[i][k]);
        const auto start = std::chrono::steady_clock::now();
        count = 0;
        for (const auto &corners : all) count += is_acute(corners);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count());
    }
    print(program, name, all.size(), count, least * 1e9 / all.size(), "ns each");
}

int main(int, char **arguments) {
    const std::string folder = std::string(arguments[1]) + "/";
    for (const char *name : {"easy", "mixed", "right"}) kernel(folder, name);
    const auto rational = [](const std::string &text) { return CGAL::Gmpq(text); };
    field<Root>("CGAL Sqrt_extension", folder, 1 << 20, [&](const auto &t) {
        return t.size() < 2 ? Root(rational(t[0])) : Root(rational(t[0]), rational(t[1]), CGAL::Gmpq(5));
    });
    const CORE::Expr root = CORE::sqrt(CORE::Expr(5));
    const auto expression = [](const std::string &text) { return CORE::Expr(CORE::BigRat(text.c_str())); };
    field<CORE::Expr>("CORE Expr", folder, 300, [&](const auto &t) {
        return t.size() < 2 ? expression(t[0]) : expression(t[0]) + expression(t[1]) * root;
    });
}
